#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace femoop {

/// How JSON writes a word that it does not know: .5 is 0.5, -010 is -10, 0x1F is 31, True is true. Nothing if the word
/// is no number in any spelling that people use, and none of true, false and null.
std::optional<std::string> json_spelling(std::string_view word);

/// A number and right behind it, or after a blank, a unit: 5kN, -2.5e3 kN.
bool is_bare_quantity(std::string_view words);

} // namespace femoop
