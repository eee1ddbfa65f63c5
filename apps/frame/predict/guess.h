#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace frame {

/// A place of a stroke beside a member, both in lengths of the member.
struct StrokePoint {
    double x = 0.0;     ///< along the member, from its first end
    double value = 0.0; ///< the ordinate there, positive where a positive moment is drawn
};

/// A diagram as a hand sketches it along one member: one ordinate, or none yet, at each of many even places.
///
/// Assumes   nothing of the hand: strokes may begin anywhere, go either way, turn back or stand upright
/// Accuracy  1/240 of the member's length; what is drawn nearer than 3 % to an end goes on to the end
class Guess {
public:
    static constexpr std::size_t n_places = 241;
    static constexpr double x(std::size_t place) { return static_cast<double>(place) / (n_places - 1); }

    /// Takes the place of what was drawn where the stroke passes; where it passes twice its latter part counts. An
    /// upright part is a jump. What lies beyond the ends, and what is no number, is left out.
    void draw(std::span<const StrokePoint> stroke);

    std::optional<double> operator[](std::size_t place) const { return values_[place]; }
    bool is_empty() const;
    double largest() const; ///< of the absolute values; 0 where nothing is drawn

private:
    void draw_line(const StrokePoint& from, const StrokePoint& to);

    std::array<std::optional<double>, n_places> values_{};
};

} // namespace frame
