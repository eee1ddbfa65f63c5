#pragma once

#include <algorithm>
#include <cstddef>

#include "femoop/element/polynomial.h"

namespace femoop {

/// The coefficient of t^power in p q.
inline double product_coefficient(const Polynomial& p, const Polynomial& q, std::size_t power)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < std::min(p.n_terms(), power + 1); ++i) sum += p[i] * q[power - i];
    return sum;
}

} // namespace femoop
