#pragma once

#include "apps/drawing/results/line_function.h"

#include <vector>

namespace drawing {

/// A value of a diagram that is worth writing beside it.
struct MarkedValue {
    double x = 0.0; ///< along the line
    double value = 0.0;
    bool is_peak = false;         ///< largest or smallest between load points, or of the whole line
    std::vector<double> others{}; ///< places with the same value, where it could be written as well
};

/// Values at the ends, on both sides of jumps, at kinks and at the exact places of extremes. A stretch of one value is
/// marked once, in its middle. Values below `least` are left out.
std::vector<MarkedValue> marked_values(const LineFunction& function, double least);

} // namespace drawing
