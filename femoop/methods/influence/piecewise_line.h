#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "femoop/model/expected.h"

namespace femoop::influence {

/// One smooth stretch of a line over a path: c[0] + c[1] t + c[2] t^2 + ..., t = s - from.
struct LinePiece {
    double from = 0.0, to = 0.0;
    std::vector<double> coefficients; ///< none is zero everywhere

    double length() const { return to - from; }
    double value(double s) const; ///< also beyond its ends
    double slope(double s) const;
    double integral(double begin, double end) const;
    /// Where it is `level` in [from, to], ascending, each once; none where it is so everywhere.
    std::vector<double> places_of(double level) const;
    std::vector<double> turning_places() const; ///< where its slope is zero, likewise

    friend bool operator==(const LinePiece&, const LinePiece&) = default;
};

/// The largest or smallest value of a line, and everywhere it is reached.
struct LineExtreme {
    double value = 0.0;
    /// Ascending; neighbours that are parts of a stretch of this value are its two ends.
    std::vector<double> positions;
    std::vector<bool> is_level_after; ///< parallel to positions: does the line keep the value up to the next one?
};

/// Areas between a line and the path, of either sign: >= 0 and <= 0.
struct LineAreas {
    double positive = 0.0, negative = 0.0;
};

/// A function of the place s along a path, smooth but for the ends of its pieces, where it may have a kink or jump.
/// Beyond the path's ends it is zero: a load that stands there does nothing.
///
/// Pieces  ascending, each begins where the one before ended; the first one at 0
struct PiecewiseLine {
    std::vector<LinePiece> pieces;

    double length() const { return pieces.empty() ? 0.0 : pieces.back().to; }
    /// At a jump, also where rounding misses it by a hair, the limit from one side; at the path's beginning and end the
    /// one that there is.
    double value(double s, Side side = Side::After) const;
    double largest() const; ///< |value| of all
    /// Ends of pieces where it jumps by more than rounding leaves.
    std::vector<double> jumps() const;

    /// Jumps count with both their limits, also where the path begins and ends.
    LineExtreme max() const;
    LineExtreme min() const;
    LineAreas areas() const;

    friend bool operator==(const PiecewiseLine&, const PiecewiseLine&) = default;
};

} // namespace femoop::influence
