#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "femoop/io/json/json_document.h"
#include "femoop/io/writer/object_text.h"
#include "femoop/model/load.h"
#include "femoop/model/node.h"
#include "femoop/model/property.h"
#include "femoop/model/quantity/units.h"

namespace femoop {

// What the files of all models have in common, as text.

inline constexpr std::size_t line_width = 120;
using Lines = std::vector<std::string>;
using NamedLists = std::vector<std::pair<std::string_view, Lines>>;

template <std::size_t N, class Enum> std::string word(const std::array<std::string_view, N>& names, Enum value)
{
    return quoted_json(names.at(static_cast<std::size_t>(value)));
}

void add_if(ObjectText& object, std::string_view key, const std::optional<Quantity>& value);

std::string text_of(const Units& units);
std::string text_of(const Material& material);
std::string text_of(DofSet dofs);
std::string text_of(const std::vector<Spring>& springs);
std::string list_of(const std::vector<Quantity>& quantities);
std::string combination_text(const Combination& combination, const std::function<std::string(CaseId)>& case_name);

/// A list with an entry a line, indented by `indent`.
std::string lines_text(const Lines& lines, std::size_t indent);
/// An object with lists behind its own keys: on one line if it fits, else with an entry a line.
std::string with_lists(ObjectText object, const NamedLists& lists);

/// The whole file: a key of the outermost object a line.
class ModelText {
public:
    void add(std::string_view key, const std::string& json)
    {
        text_ += (text_.size() > 1 ? ",\n  \"" : "\n  \"") + std::string(key) + "\": " + json;
    }
    void add_text(std::string_view key, const std::string& value)
    {
        if (!value.empty()) add(key, quoted_json(value));
    }
    /// Each entry as `write` gives it.
    template <class List, class Write> void add_list(std::string_view key, const List& list, const Write& write)
    {
        Lines lines;
        for (const auto& entry : list) lines.push_back(write(entry));
        add(key, lines_text(lines, 2));
    }
    template <class List, class Write> void add_list_if(std::string_view key, const List& list, const Write& write)
    {
        if (!list.empty()) add_list(key, list, write);
    }
    std::string str() const { return text_ + "\n}\n"; }

private:
    std::string text_ = "{";
};

} // namespace femoop
