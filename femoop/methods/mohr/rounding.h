#pragma once

#include <cmath>
#include <initializer_list>
#include <limits>

namespace femoop::mohr {

/// The value, or 0 where it is nothing but rounding of what it comes from. A value is never too small by itself.
/// \param magnitude  the sizes of what it comes from, added up
inline double without_rounding(double value, double magnitude)
{
    constexpr double rounding = 512.0 * std::numeric_limits<double>::epsilon(); // of decimals with fourteen digits too
    return std::abs(value) <= rounding * magnitude ? 0.0 : value;
}

/// The sum, or 0 where the terms cancel but for their rounding.
inline double sum_of(std::initializer_list<double> terms)
{
    double sum = 0.0, magnitude = 0.0;
    for (const double term : terms) {
        sum += term;
        magnitude += std::abs(term);
    }
    return without_rounding(sum, magnitude);
}

} // namespace femoop::mohr
