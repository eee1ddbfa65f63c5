#pragma once

#include "ui/paint/color.h"

#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>

namespace ui {

/// Lengths in logical pixels, drawn and skipped by turns, beginning with a drawn one; empty means a solid line.
/// At most six lengths: `DashPattern{8, 4}` is dashed, `DashPattern{10, 4, 2, 4}` is dash-dot.
class DashPattern {
public:
    static constexpr std::size_t max_lengths = 6;

    constexpr DashPattern() = default;
    /// \throws std::invalid_argument when a length is negative or not finite, all are zero, the number of lengths is
    /// odd, or there are more than six.
    DashPattern(std::initializer_list<double> lengths);

    bool is_solid() const { return count_ == 0; }
    std::span<const double> lengths() const { return {lengths_.data(), count_}; }
    double period() const; ///< sum of the lengths
    /// The same rhythm for a line `factor` times as thick.
    DashPattern scaled(double factor) const;

    friend bool operator==(const DashPattern&, const DashPattern&) = default;

private:
    std::array<double, max_lengths> lengths_{};
    std::size_t count_ = 0;
};

enum class Cap { Butt, Round, Square };
/// Miter falls back to Bevel at corners sharper than 29 degrees, where it would be longer than four widths (as in SVG).
enum class Join { Miter, Round, Bevel };

/// How a line is drawn. Width in logical pixels.
struct Stroke {
    Color color{};
    double width = 1.0;
    DashPattern dash{};
    Cap cap = Cap::Butt;
    Join join = Join::Miter;

    friend bool operator==(const Stroke&, const Stroke&) = default;
};

enum class Weight { Regular, Bold };

/// The point of a text's box that is put at the given place. "Middle" of the height is half a capital letter's
/// height, so that digits look centred.
enum class Anchor { TopLeft, Top, TopRight, Left, Center, Right, BottomLeft, Bottom, BottomRight };

/// How a string is drawn. Size is the em in logical pixels.
struct TextStyle {
    Color color{};
    double size = 13.0;
    Weight weight = Weight::Regular;
    Anchor anchor = Anchor::Center;
    double rotation = 0.0; ///< [rad] about the anchor, positive counter-clockwise as seen
    /// A filled box behind the text, a little larger than it, that keeps the text readable over lines.
    std::optional<Color> plate{};

    friend bool operator==(const TextStyle&, const TextStyle&) = default;
};

/// Drawn from first to last; within a layer, in the order of the calls.
enum class Layer { Background, Grid, Areas, Lines, Symbols, Labels, Overlay };
inline constexpr std::size_t n_layers = 7;

} // namespace ui
