#include "ui/text/number_format.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "femoop/tabular/halves.h"
#include "ui/text/arithmetic.h"

namespace ui {

namespace {

void drop_trailing_zeros(std::string& digits)
{
    if (digits.find('.') == std::string::npos) return;
    while (digits.back() == '0') digits.pop_back();
    if (digits.back() == '.') digits.pop_back();
}

std::string written(double value, std::chars_format format, int precision)
{
    std::array<char, 64> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, precision).ptr;
    return {buffer.data(), end};
}

double value_of(std::string_view digits)
{
    double value = 0.0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

/// Of a number in scientific form.
int exponent_of(std::string_view digits)
{
    digits.remove_prefix(digits.find('e') + 1);
    if (digits.front() == '+') digits.remove_prefix(1);
    int exponent = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    return exponent;
}

// "1.20e-05" becomes "1.2e-5".
std::string with_exponent(double value, int digits)
{
    const std::string text = written(value, std::chars_format::scientific, digits - 1);
    const std::size_t e = text.find('e');
    std::string mantissa = text.substr(0, e);
    drop_trailing_zeros(mantissa);
    std::string exponent = text[e + 1] == '-' ? "-" : "";
    return mantissa + 'e' + exponent + text.substr(std::min(text.find_first_not_of("+-0", e + 1), text.size() - 1));
}

} // namespace

std::string number_text(double value, const NumberFormat& format)
{
    if (!std::isfinite(value)) return "–";
    if (value == 0.0) return "0";
    const int digits = std::clamp(format.digits, 1, 15);
    if (digits <= 10) value = tabular::off_half(value);
    const std::string rounded = written(value, std::chars_format::scientific, digits - 1);
    const int exponent = exponent_of(rounded);
    std::string text;
    if (exponent < -4 || exponent >= 7) {
        text = with_exponent(value, digits);
    } else {
        // Rounded first, so that 1234567 with three digits is 1230000.
        text = written(value_of(rounded), std::chars_format::fixed, std::max(0, digits - 1 - exponent));
        drop_trailing_zeros(text);
    }
    if (format.mark == DecimalMark::Comma) std::replace(text.begin(), text.end(), '.', ',');
    return text;
}

std::string with_minus_signs(std::string_view number)
{
    std::string text;
    for (const char c : number) text += c == '-' ? std::string("−") : std::string(1, c);
    return text;
}

std::optional<double> number_typed(std::string_view text)
{
    const std::optional<LeadingNumber> number = leading_number(text);
    if (!number) return std::nullopt;
    const bool is_whole = text.find_first_not_of(" \t", number->length) == std::string_view::npos;
    return is_whole ? std::optional(number->value) : std::nullopt;
}

} // namespace ui
