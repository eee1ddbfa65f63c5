#pragma once

#include <vector>

namespace frame {

/// The multiples of a step from `least` to `most`. None where a step is lost in the rounding of places so far from the
/// origin: there is no grid to be seen there. \pre step > 0
std::vector<double> multiples_between(double least, double most, double step);

} // namespace frame
