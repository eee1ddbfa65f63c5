#include "apps/drawing/grid.h"

#include <algorithm>
#include <cmath>

namespace drawing {

std::vector<double> multiples_between(double least, double most, double step)
{
    constexpr double resolved = 1e-12; // of a place: less is rounding
    std::vector<double> places;
    if (!(step > resolved * std::max(std::abs(least), std::abs(most)))) return places;
    const double first = std::ceil(least / step), last = std::floor(most / step);
    for (double i = first; i <= last; ++i) places.push_back(i * step);
    return places;
}

double round_grid(double smallest)
{
    const double power = std::pow(10.0, std::floor(std::log10(smallest)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= smallest * (1.0 - 1e-12)) return factor * power;
    return 10.0 * power;
}

} // namespace drawing
