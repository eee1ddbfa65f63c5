#pragma once

#include <cstddef>
#include <vector>

#include "femoop/methods/influence/influence_line.h"

namespace femoop::influence {

/// What the eye looks for in an influence line: where it is zero, where it jumps and breaks, and what it is between.
///
///        straight        straight       cubic
///     0--------.                  .-----------.
///               `-----.|     .---'             `0
///     zero           jump  kink                zero
///
/// Accuracy  what is below a millionth of the largest ordinate is rounding
struct LineShape {
    struct Jump {
        double s = 0.0, before = 0.0, after = 0.0;
    };
    /// Neighbouring pieces of one degree, which may have kinks and jumps between them.
    struct Stretch {
        double from = 0.0, to = 0.0;
        int degree = 0;
        bool is_series = false; ///< on a foundation or along a taper: no polynomial
        bool is_zero = false;
        std::size_t n_pieces = 1; ///< of different formulas
    };
    std::vector<double> zeros; ///< places, ascending; neither in a stretch of zero nor at a jump
    std::vector<Jump> jumps;   ///< ascending
    std::vector<double> kinks; ///< ascending
    std::vector<Stretch> stretches;
};

LineShape shape_of(const InfluenceLine& line);

} // namespace femoop::influence
