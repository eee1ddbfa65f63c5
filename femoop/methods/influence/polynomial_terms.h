#pragma once

#include <vector>

#include "femoop/element/polynomial.h"

namespace femoop::influence {

Polynomial polynomial_of(const std::vector<double>& coefficients);

Polynomial negated(const Polynomial& p);

} // namespace femoop::influence
