#pragma once

#include <vector>

namespace femoop::plane {

/// Levels at equal steps of 1, 2, 2.5 or 5 times a power of ten that enclose a range: the first is not above it, the last
/// not below it, and there are about as many steps as are wanted. Of a range without width, as small as rounding makes
/// it, two levels about it.
std::vector<double> round_levels(double low, double high, int n_steps = 10);
/// Equal steps over exactly this range. \pre low < high
std::vector<double> equal_levels(double low, double high, int n_steps = 10);

} // namespace femoop::plane
