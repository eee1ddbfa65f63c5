#pragma once

#include <vector>

#include "femoop/element/polynomial.h"

namespace femoop::influence {

Polynomial polynomial_of(const std::vector<double>& coefficients);

Polynomial negated(const Polynomial& p);

/// p(t + start).
Polynomial about(const Polynomial& p, double start);

} // namespace femoop::influence
