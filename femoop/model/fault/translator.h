#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace femoop {

/// Turns an English text into the reader's language. What has no translation comes back as it is, so
/// `english` (below) is a translator too.
using Translator = std::function<std::string(std::string_view english)>;

/// Marks a word or sentence that is translated later, where it stands in a table: the test of the translation files
/// looks for it.
constexpr std::string_view translatable(std::string_view english) { return english; }

inline std::string english(std::string_view text) { return std::string(text); }

} // namespace femoop
