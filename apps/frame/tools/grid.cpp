#include "apps/frame/tools/grid.h"

#include <algorithm>
#include <cmath>

namespace frame {

std::vector<double> multiples_between(double least, double most, double step)
{
    constexpr double resolved = 1e-12; // of a place: less is rounding
    std::vector<double> places;
    if (!(step > resolved * std::max(std::abs(least), std::abs(most)))) return places;
    const double first = std::ceil(least / step), last = std::floor(most / step);
    for (double i = first; i <= last; ++i) places.push_back(i * step);
    return places;
}

} // namespace frame
