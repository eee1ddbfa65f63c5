#include "femoop/methods/influence/polynomial_terms.h"

#include <array>
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

Polynomial about(const Polynomial& p, double start)
{
    if (start == 0.0) return p;
    std::array<double, Polynomial::max_terms> c; // NOLINT: only the first n mean anything, and are set
    const std::size_t n = p.n_terms();
    for (std::size_t i = 0; i < n; ++i) c[i] = p[i];
    for (std::size_t i = 0; i + 1 < n; ++i)
        for (std::size_t j = n - 1; j-- > i;) c[j] += start * c[j + 1];
    Polynomial moved;
    for (std::size_t i = 0; i < n; ++i) moved.append(c[i]);
    return moved;
}

} // namespace femoop::influence
