#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "femoop/io/json/json_document.h"
#include "femoop/model/quantity/quantity.h"

namespace femoop {

std::string json_text(double value);          ///< \pre finite, for JSON has nothing else. \throws std::invalid_argument
std::string json_text(const Quantity& value); ///< as it was typed: a number, or a text with a unit
std::string json_list(const std::vector<std::string>& values);

/// One JSON object on one line, written key by key: {"id": "A", "at": [0, 4]}.
class ObjectText {
public:
    ObjectText& add(std::string_view key, std::string_view json)
    {
        if (text_.size() > 1) text_ += ", ";
        text_ += quoted_json(key);
        text_ += ": ";
        text_ += json;
        return *this;
    }
    ObjectText& add_text(std::string_view key, std::string_view value) { return add(key, quoted_json(value)); }
    ObjectText& add(std::string_view key, const Quantity& value) { return add(key, json_text(value)); }

    bool is_empty() const { return text_.size() == 1; }
    std::string str() const { return text_ + '}'; }

private:
    std::string text_ = "{";
};

} // namespace femoop
