#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace ui {

enum class DecimalMark : std::uint8_t { Point, Comma };

/// How numbers are written for people. Files and the command line's JSON never use it.
struct NumberFormat {
    int digits = 4; ///< significant, 1 to 15
    DecimalMark mark = DecimalMark::Point;

    friend bool operator==(const NumberFormat&, const NumberFormat&) = default;
};

/// The value rounded to the format's significant digits, without trailing zeros: 12.5, 0.0032, 205000, 1.2e-5.
/// Powers of ten are used below 1e-4 and from 1e7 on. Minus zero is 0, what is not finite is a dash.
std::string number_text(double value, const NumberFormat& format = {});

/// The same with true minus signs, as a picture writes it: −12.5, 1.2e−5.
std::string with_minus_signs(std::string_view number);

/// A number that a person typed, with a decimal point or a decimal comma, or a small calculation
/// (ui/text/arithmetic.h), blanks around it allowed; nothing for anything else, for what is not finite, and for a text
/// with both marks.
std::optional<double> number_typed(std::string_view text);

} // namespace ui
