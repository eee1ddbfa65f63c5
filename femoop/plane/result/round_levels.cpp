#include "femoop/plane/result/round_levels.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace femoop::plane {

namespace {

constexpr double rounding = 1e-9; // of the larger end: a narrower range is one value
constexpr double least_size = std::numeric_limits<double>::min() /
                              rounding; // of which that is a number with its digits

/// The round number that is not less than this, but for rounding.
double round_step(double least)
{
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 2.5, 5.0})
        if (factor * power >= least * (1.0 - rounding)) return factor * power;
    return 10.0 * power;
}

} // namespace

std::vector<double> round_levels(double low, double high, int n_steps)
{
    const double size = std::max(std::abs(low), std::abs(high));
    if (size < least_size) return {0.0, 1.0};
    if (!(high - low > rounding * size)) return {low, high + rounding * size};
    if (!std::isfinite(high - low)) return {low, 0.0, high};
    const double step = round_step((high - low) / n_steps);
    const double first = std::floor(low / step + rounding), last = std::ceil(high / step - rounding);
    std::vector<double> levels;
    for (double k = first; k <= last + 0.5; k += 1.0) levels.push_back(k * step);
    return levels;
}

std::vector<double> equal_levels(double low, double high, int n_steps)
{
    std::vector<double> levels;
    for (int k = 0; k <= n_steps; ++k) levels.push_back(low + (high - low) * k / n_steps);
    return levels;
}

} // namespace femoop::plane
