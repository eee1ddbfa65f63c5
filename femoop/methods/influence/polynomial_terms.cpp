#include "femoop/methods/influence/polynomial_terms.h"

#include <cstddef>

namespace femoop::influence {

Polynomial polynomial_of(const std::vector<double>& coefficients)
{
    Polynomial p;
    for (const double c : coefficients) p.append(c);
    return p;
}

Polynomial negated(const Polynomial& p)
{
    Polynomial negative;
    for (std::size_t i = 0; i < p.n_terms(); ++i) negative.append(-p[i]);
    return negative;
}

} // namespace femoop::influence
