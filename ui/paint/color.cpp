#include "ui/paint/color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace ui {

namespace {

std::uint8_t blend(std::uint8_t a, std::uint8_t b, double t)
{
    return static_cast<std::uint8_t>(std::lround(a + (b - a) * t));
}

std::array<double, 256> linear_values()
{
    std::array<double, 256> values;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double c = static_cast<double>(i) / 255.0;
        values[i] = c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    }
    return values;
}

double linear(std::uint8_t channel)
{
    static const std::array<double, 256> values = linear_values(); // a theme asks for hundreds
    return values[channel];
}

double luminance(Color color) { return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b); }

void append_hex(std::string& text, std::uint8_t value)
{
    constexpr std::string_view digits = "0123456789abcdef";
    text += digits[value >> 4];
    text += digits[value & 0xF];
}

} // namespace

Color mixed(Color a, Color b, double t)
{
    const double s = std::clamp(t, 0.0, 1.0);
    return {blend(a.r, b.r, s), blend(a.g, b.g, s), blend(a.b, b.b, s), blend(a.a, b.a, s)};
}

double contrast_ratio(Color a, Color b)
{
    const double la = luminance(a), lb = luminance(b);
    return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

std::string hex_text(Color color)
{
    std::string text = "#";
    append_hex(text, color.r);
    append_hex(text, color.g);
    append_hex(text, color.b);
    if (color.a != 255) append_hex(text, color.a);
    return text;
}

} // namespace ui
