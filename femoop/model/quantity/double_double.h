#pragma once

#include <cmath>
#include <cstdint>

namespace femoop {

/// An unevaluated sum hi + lo with |lo| <= ulp(hi) / 2: about 106 bits, enough to round a unit conversion once.
///
/// Source  [Dekker1971], error-free product by fused multiply-add
struct DoubleDouble {
    double hi = 0.0;
    double lo = 0.0;

    DoubleDouble() = default;
    DoubleDouble(double value) : hi(value) {} // NOLINT: every double is a double-double
    DoubleDouble(double high, double low) : hi(high + low), lo(low - (hi - high)) {}

    double rounded() const { return hi; }
};

inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b)
{
    const double product = a.hi * b.hi;
    const double error = std::fma(a.hi, b.hi, -product);
    return {product, error + (a.hi * b.lo + a.lo * b.hi)};
}

inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b)
{
    const double difference = a.hi - b.hi;
    const double back = difference - a.hi;
    const double error = (a.hi - (difference - back)) - (b.hi + back);
    return {difference, error + (a.lo - b.lo)};
}

inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b)
{
    const double first = a.hi / b.hi;
    const DoubleDouble rest = a - b * first;
    const double second = rest.hi / b.hi;
    const double third = (rest - b * second).hi / b.hi;
    const DoubleDouble sum(first, second);
    return {sum.hi, sum.lo + third};
}

/// \pre exponent >= 0. Exact up to 10^45.
inline DoubleDouble power(DoubleDouble base, int exponent)
{
    DoubleDouble result = 1.0;
    for (; exponent > 0; exponent /= 2, base = base * base)
        if (exponent % 2 == 1) result = result * base;
    return result;
}

} // namespace femoop
