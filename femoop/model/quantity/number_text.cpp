#include "femoop/model/quantity/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace femoop {

namespace {

// to_chars writes 1e-05 and 2e+08; people write 1e-5 and 2e8.
std::string without_padding(std::string_view text)
{
    const std::size_t e = text.find('e');
    if (e == std::string_view::npos) return std::string(text);
    std::string_view exponent = text.substr(e + 1);
    const bool is_negative = exponent.front() == '-';
    exponent.remove_prefix(1);
    while (exponent.size() > 1 && exponent.front() == '0') exponent.remove_prefix(1);
    return std::string(text.substr(0, e + 1)) + (is_negative ? "-" : "") + std::string(exponent);
}

} // namespace

std::string number_text(double value)
{
    if (value == 0.0) return std::signbit(value) ? "-0.0" : "0";
    const double size = std::abs(value);
    const auto format = size >= 1e-4 && size < 1e7 ? std::chars_format::fixed : std::chars_format::scientific;
    std::array<char, 64> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format).ptr;
    return without_padding({buffer.data(), static_cast<std::size_t>(end - buffer.data())});
}

std::string localized(std::string number, const Translator& tr)
{
    std::replace(number.begin(), number.end(), '.', decimal_mark(tr));
    return number;
}

std::optional<std::string> with_hyphen(std::string_view text)
{
    for (const std::string_view dash : {"\u2212", "\u2013", "\u2014"})
        if (text.starts_with(dash)) return '-' + std::string(text.substr(dash.size()));
    return std::nullopt;
}

std::string quantity_text(double value, Dimension dimension, const Units& units)
{
    const std::string unit = unit_text(dimension, units);
    return number_text(value) + (unit.empty() ? "" : " " + unit);
}

} // namespace femoop
