#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace ui {

/// A number at the beginning of a text, and how far it goes.
struct LeadingNumber {
    double value = 0.0;
    std::size_t length = 0;   ///< characters, blanks before it included
    bool is_computed = false; ///< written as a sum, product, quotient, power or in parentheses
};

/// Reads a number that a person typed or a small calculation, as far as it goes: "12,5", "2*3.5 kN/m" (up to the unit),
/// "1/3", "-(2+3)^2". The usual precedence holds; a power binds from the right.
///
///     sum     = product { ("+" | "-") product }
///     product = factor { ("*" | "/") factor }
///     factor  = [sign] power          power = atom [ "^" factor ]
///     atom    = number | "(" sum ")"  number with a decimal point or a decimal comma
///
/// Nothing where the text does not begin with one, where decimal points and decimal commas are mixed, and for what is
/// not finite, such as 1/0.
std::optional<LeadingNumber> leading_number(std::string_view text);

/// The calculation at the beginning of the text divides by zero, so that it has no value: 1/0, 3/(2-2) kN.
bool divides_by_zero(std::string_view text);

} // namespace ui
