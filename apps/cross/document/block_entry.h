#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace femoop {
class JsonValue;
}

namespace cross {

/// A `cross` block with another value under one of its keys, or without it; all else in it stays.
std::string with_entry(const std::string& block_json, std::string_view key, const std::optional<std::string>& json);

/// What an object has under `key`; absent where it has nothing.
femoop::JsonValue entry_of(femoop::JsonValue object, std::string_view key);

} // namespace cross
