#include "apps/cross/document/block_entry.h"

#include "femoop/io/json/json_document.h"

namespace cross {

std::string with_entry(const std::string& block_json, std::string_view key, const std::optional<std::string>& json)
{
    const femoop::JsonReading reading = femoop::parse_json(block_json);
    if (!reading.document) return block_json;
    std::string text;
    const auto add = [&](std::string_view name, const std::string& value) {
        text += (text.empty() ? "" : ", ") + femoop::quoted_json(name) + ": " + value;
    };
    for (const femoop::JsonValue value : reading.document->root())
        if (value.key() != key) add(value.key(), femoop::compact_json(value));
    if (json) add(key, *json);
    return "{" + text + "}";
}

femoop::JsonValue entry_of(femoop::JsonValue object, std::string_view key)
{
    for (const femoop::JsonValue value : object)
        if (value.key() == key) return value;
    return {};
}

} // namespace cross
