#pragma once

#include <cstdint>
#include <string>

namespace ui {

/// sRGB colour with straight (not premultiplied) alpha, 0..255 each.
struct Color {
    std::uint8_t r = 0;
    std::uint8_t g = 0;
    std::uint8_t b = 0;
    std::uint8_t a = 255;

    friend bool operator==(const Color&, const Color&) = default;
};

/// 0xRRGGBB, opaque: `rgb(0x0072B2)`.
constexpr Color rgb(std::uint32_t hex)
{
    return {static_cast<std::uint8_t>((hex >> 16) & 0xFFu), static_cast<std::uint8_t>((hex >> 8) & 0xFFu),
            static_cast<std::uint8_t>(hex & 0xFFu), 255};
}

/// The same hue with another opacity, 0 (invisible) to 1 (opaque); values outside are taken to the nearer end.
constexpr Color with_opacity(Color color, double opacity)
{
    const double clamped = opacity < 0.0 ? 0.0 : (opacity > 1.0 ? 1.0 : opacity);
    color.a = static_cast<std::uint8_t>(clamped * 255.0 + 0.5); // NOLINT: it is not negative
    return color;
}

/// a at t = 0, b at t = 1, linear between in sRGB values.
Color mixed(Color a, Color b, double t);

/// Contrast ratio of two opaque colours, 1 (equal) to 21 (black on white).
/// Source: WCAG 2.1, definitions of "contrast ratio" and "relative luminance".
double contrast_ratio(Color a, Color b);

/// "#rrggbb", and "#rrggbbaa" where it is not opaque.
std::string hex_text(Color color);

} // namespace ui
