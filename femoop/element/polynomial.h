#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

namespace femoop {

/// A polynomial p(t) = c[0] + c[1] t + c[2] t^2 + ..., held on the stack.
///
/// Solutions along a member are polynomials of degree five at most; on an elastic foundation and along a taper they are
/// power series, cut where the next term no longer changes the last bit.
class Polynomial {
public:
    static constexpr std::size_t max_terms = 24;

    Polynomial() {} // NOLINT: leaves c_ as it is
    Polynomial(std::initializer_list<double> coefficients);

    std::size_t n_terms() const { return n_; }
    double operator[](std::size_t power) const { return power < n_ ? c_[power] : 0.0; }
    void append(double coefficient); ///< of the next power \pre n_terms() < max_terms

    double operator()(double t) const
    {
        double value = 0.0;
        for (std::size_t i = n_; i-- > 0;) value = value * t + c_[i];
        return value;
    }

    Polynomial derivative() const;

    /// p(t + by), of as many terms.
    Polynomial shifted(double by) const;

    /// Power series of 1 / p, of max_terms terms: within a sixth of the way to the nearest zero of p, which may be
    /// complex, it gives every digit. \pre p(0) != 0
    Polynomial reciprocal() const;

    /// Integral of t^power p(t) from 0 to end.
    double moment(std::size_t power, double end) const;

    /// Where p is zero in [0, end], ascending, each root once. A p that is zero everywhere has none.
    /// A minimum or maximum that misses zero by rounding alone counts as a root.
    /// \pre end > 0
    std::vector<double> roots(double end) const;

private:
    std::array<double, max_terms> c_; // only the first n_ mean anything: polynomials are made by the million
    std::size_t n_ = 0;
};

/// Makes of the coefficients of p(t) those of p(t + by).
void shift_coefficients(std::span<double> coefficients, double by);

} // namespace femoop
