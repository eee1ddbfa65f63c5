#include "femoop/io/json/json_document.h"

#include <array>
#include <cstring>
#include <utility>

#include "femoop/model/fault/translator.h"
#include "femoop/model/quantity/number_text.h"

namespace femoop {

std::string_view name(JsonKind kind)
{
    static constexpr std::array<std::string_view, 7> names{
        translatable("nothing"), translatable("null"),   translatable("true or false"), translatable("a number"),
        translatable("a text"),  translatable("a list"), translatable("an object")};
    return names[static_cast<std::size_t>(kind)];
}

JsonDocument::JsonDocument() : texts_(std::make_unique<std::pmr::monotonic_buffer_resource>()) {}

JsonValue JsonDocument::root() const { return entries_.empty() ? JsonValue() : JsonValue(this, 0); }

std::string_view JsonDocument::keep(std::string_view text)
{
    if (text.empty()) return {};
    auto* const copy = static_cast<char*>(texts_->allocate(text.size(), 1));
    std::memcpy(copy, text.data(), text.size());
    return {copy, text.size()};
}

JsonKind JsonValue::kind() const { return document_ ? document_->entries_[index_].kind : JsonKind::Absent; }
std::string_view JsonValue::key() const { return document_->entries_[index_].key; }
std::string_view JsonValue::text() const { return document_->entries_[index_].text; }
double JsonValue::number() const { return document_->entries_[index_].number; }
bool JsonValue::boolean() const { return document_->entries_[index_].number != 0.0; }

JsonValue::Iterator JsonValue::begin() const
{
    const bool holds_values = is(JsonKind::Array) || is(JsonKind::Object);
    return holds_values ? Iterator(JsonValue(document_, index_ + 1)) : end();
}

JsonValue::Iterator JsonValue::end() const
{
    return Iterator(JsonValue(document_, document_ ? document_->entries_[index_].end : 0));
}

std::size_t JsonValue::size() const
{
    std::size_t n = 0;
    for (Iterator it = begin(); it != end(); ++it) ++n;
    return n;
}

JsonValue::Iterator& JsonValue::Iterator::operator++()
{
    value_.index_ = value_.document_->entries_[value_.index_].end;
    return *this;
}

std::string quoted_json(std::string_view text)
{
    static constexpr std::string_view hex = "0123456789abcdef";
    std::string quoted = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\') quoted += {'\\', c};
        else if (c == '\n') quoted += "\\n";
        else if (c == '\t') quoted += "\\t";
        else if (code < 0x20) quoted += {'\\', 'u', '0', '0', hex[code / 16U], hex[code % 16U]};
        else quoted += c;
    }
    return quoted + '"';
}

namespace {

std::string scalar(JsonValue value)
{
    switch (value.kind()) {
    case JsonKind::Boolean: return value.boolean() ? "true" : "false";
    case JsonKind::Number: return number_text(value.number());
    case JsonKind::String: return quoted_json(value.text());
    default: return "null";
    }
}

bool is_scalar(JsonValue value) { return !value.is(JsonKind::Array) && !value.is(JsonKind::Object); }

/// A row of plain values reads best on one line, however long.
bool is_row(JsonValue value)
{
    for (const JsonValue inner : value)
        if (!is_scalar(inner)) return false;
    return true;
}

} // namespace

// Recursion is as deep as the document, which is at most JsonDocument::deepest.
std::string compact_json(JsonValue value)
{
    if (is_scalar(value)) return scalar(value);
    const bool is_object = value.is(JsonKind::Object);
    std::string text = is_object ? "{" : "[";
    for (const JsonValue inner : value) {
        if (text.size() > 1) text += ", ";
        if (is_object) text += quoted_json(inner.key()) + ": ";
        text += compact_json(inner);
    }
    return text + (is_object ? '}' : ']');
}

std::string pretty_json(JsonValue value, std::size_t indent, std::size_t width)
{
    std::string line = compact_json(value);
    if (is_scalar(value) || line.size() <= width || is_row(value)) return line;
    const bool is_object = value.is(JsonKind::Object);
    const std::string margin(indent + 2, ' ');
    std::string text;
    for (const JsonValue inner : value) {
        const std::string key = is_object ? quoted_json(inner.key()) + ": " : "";
        const std::size_t taken = key.size() + 3; // indentation's own two blanks and a comma
        const std::size_t left = width > taken ? width - taken : 0;
        text += (text.empty() ? "\n" : ",\n") + margin + key + pretty_json(inner, indent + 2, left);
    }
    return (is_object ? "{" : "[") + text + "\n" + std::string(indent, ' ') + (is_object ? "}" : "]");
}

} // namespace femoop
