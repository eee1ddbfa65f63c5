#pragma once

#include <vector>

namespace drawing {

/// The multiples of a step from `least` to `most`. None where a step is lost in the rounding of places so far from the
/// origin: there is no grid to be seen there. \pre step > 0
std::vector<double> multiples_between(double least, double most, double step);

/// A distance of grid lines that is round (1, 2 or 5 times a power of ten) and at least `smallest`.
double round_grid(double smallest);

} // namespace drawing
