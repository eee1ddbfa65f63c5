#include "femoop/io/json/json_writer.h"

#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "femoop/io/json/json_document.h"

namespace femoop {

JsonWriter& JsonWriter::begin_object(Layout layout) { return begin(true, layout); }
JsonWriter& JsonWriter::begin_array(Layout layout) { return begin(false, layout); }

JsonWriter& JsonWriter::begin(bool is_object, Layout layout)
{
    next_item();
    text_ += is_object ? '{' : '[';
    levels_.push_back({is_object, layout, true});
    return *this;
}

JsonWriter& JsonWriter::end()
{
    if (levels_.empty()) throw std::logic_error("JsonWriter: nothing to end");
    const Level level = levels_.back();
    levels_.pop_back();
    if (level.layout == Layout::Block && !level.is_empty) new_line();
    text_ += level.is_object ? '}' : ']';
    return *this;
}

JsonWriter& JsonWriter::key(std::string_view key)
{
    next_item();
    text_ += quoted_json(key);
    text_ += ": ";
    last_key_ = key;
    has_key_ = true;
    return *this;
}

JsonWriter& JsonWriter::value(double number)
{
    if (!std::isfinite(number)) throw std::domain_error("\"" + last_key_ + "\" is not a finite number");
    next_item();
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number == 0.0 ? 0.0 : number).ptr;
    text_.append(digits.data(), end);
    return *this;
}

JsonWriter& JsonWriter::value(int number)
{
    next_item();
    text_ += std::to_string(number);
    return *this;
}

JsonWriter& JsonWriter::value(std::size_t number)
{
    next_item();
    text_ += std::to_string(number);
    return *this;
}

JsonWriter& JsonWriter::value(std::string_view text)
{
    next_item();
    text_ += quoted_json(text);
    return *this;
}

JsonWriter& JsonWriter::value(bool truth)
{
    next_item();
    text_ += truth ? "true" : "false";
    return *this;
}

JsonWriter& JsonWriter::null()
{
    next_item();
    text_ += "null";
    return *this;
}

JsonWriter& JsonWriter::json(std::string_view written)
{
    next_item();
    text_ += written;
    return *this;
}

std::string JsonWriter::take()
{
    if (!levels_.empty()) throw std::logic_error("JsonWriter: an object or array was not ended");
    text_ += '\n';
    return std::move(text_);
}

void JsonWriter::next_item()
{
    if (has_key_) {
        has_key_ = false;
        return;
    }
    if (levels_.empty()) return;
    Level& level = levels_.back();
    if (!level.is_empty) text_ += level.layout == Layout::Block ? "," : ", ";
    level.is_empty = false;
    if (level.layout == Layout::Block) new_line();
}

void JsonWriter::new_line()
{
    text_ += '\n';
    text_.append(2 * levels_.size(), ' ');
}

} // namespace femoop
