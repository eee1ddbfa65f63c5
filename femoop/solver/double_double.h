#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cmath>

namespace femoop {

/// A number of some 32 digits as the sum of two doubles: what cancels in a chain of thousands of members is less.
///
///     x = hi + lo, |lo| no more than half of the last bit of hi
///
/// Source  [Dekker1971]
struct DoubleDouble {
    double hi = 0.0, lo = 0.0;

    constexpr DoubleDouble() = default;
    constexpr DoubleDouble(double value) : hi(value) {} // NOLINT: meant to convert
    constexpr DoubleDouble(double high, double low) : hi(high), lo(low) {}
    explicit constexpr operator double() const { return hi; }

    /// The sum of two doubles, nothing lost.
    static DoubleDouble sum(double a, double b)
    {
        const double s = a + b, of_b = s - a;
        return {s, (a - (s - of_b)) + (b - of_b)};
    }
    /// Their product, nothing lost.
    static DoubleDouble product(double a, double b)
    {
        const double p = a * b;
#ifdef FP_FAST_FMA
        return {p, std::fma(a, b, -p)};
#else
        const DoubleDouble x = halves(a), y = halves(b);
        return {p, ((x.hi * y.hi - p) + x.hi * y.lo + x.lo * y.hi) + x.lo * y.lo};
#endif
    }

    DoubleDouble operator-() const { return {-hi, -lo}; }
    DoubleDouble& operator+=(DoubleDouble b) { return *this = *this + b; }
    DoubleDouble& operator-=(DoubleDouble b) { return *this = *this - b; }
    DoubleDouble& operator*=(DoubleDouble b) { return *this = *this * b; }
    DoubleDouble& operator/=(DoubleDouble b) { return *this = *this / b; }

    friend DoubleDouble operator+(DoubleDouble a, DoubleDouble b)
    {
        const DoubleDouble high = sum(a.hi, b.hi), low = sum(a.lo, b.lo);
        const DoubleDouble middle = quick_sum(high.hi, high.lo + low.hi);
        return quick_sum(middle.hi, middle.lo + low.lo);
    }
    friend DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }
    friend DoubleDouble operator*(DoubleDouble a, DoubleDouble b)
    {
        const DoubleDouble p = product(a.hi, b.hi);
        return quick_sum(p.hi, p.lo + (a.hi * b.lo + a.lo * b.hi));
    }
    friend DoubleDouble operator/(DoubleDouble a, DoubleDouble b)
    {
        const double first = a.hi / b.hi;
        DoubleDouble rest = a - b * DoubleDouble(first);
        const double second = rest.hi / b.hi;
        rest -= b * DoubleDouble(second);
        return quick_sum(first, second) + DoubleDouble(rest.hi / b.hi);
    }
    friend bool operator==(DoubleDouble a, DoubleDouble b) { return a.hi == b.hi && a.lo == b.lo; }
    friend bool operator<(DoubleDouble a, DoubleDouble b) { return a.hi < b.hi || (a.hi == b.hi && a.lo < b.lo); }
    friend bool operator>(DoubleDouble a, DoubleDouble b) { return b < a; }
    friend bool operator<=(DoubleDouble a, DoubleDouble b) { return !(b < a); }
    friend bool operator>=(DoubleDouble a, DoubleDouble b) { return !(a < b); }

private:
    /// \pre |a| >= |b|, or a is 0
    static DoubleDouble quick_sum(double a, double b)
    {
        const double s = a + b;
        return {s, b - (s - a)};
    }
    /// The upper and the lower 26 bits.
    static DoubleDouble halves(double a)
    {
        const double shifted = 134217729.0 * a; // 2^27 + 1
        const double upper = shifted - (shifted - a);
        return {upper, a - upper};
    }
};

inline DoubleDouble abs(DoubleDouble x) { return x.hi < 0.0 ? -x : x; }

using PreciseVector = Eigen::Matrix<DoubleDouble, Eigen::Dynamic, 1>;
using PreciseMatrix = Eigen::Matrix<DoubleDouble, Eigen::Dynamic, Eigen::Dynamic>;
using PreciseSparseMatrix = Eigen::SparseMatrix<DoubleDouble>; ///< lower triangle, as SparseMatrix

/// The nearest doubles.
template <class Derived> Eigen::MatrixXd rounded(const Eigen::MatrixBase<Derived>& values)
{
    return values.unaryExpr([](DoubleDouble x) { return x.hi; });
}

} // namespace femoop

template <> struct Eigen::NumTraits<femoop::DoubleDouble> : Eigen::GenericNumTraits<femoop::DoubleDouble> {
    using Real = femoop::DoubleDouble;
    using NonInteger = femoop::DoubleDouble;
    using Nested = femoop::DoubleDouble;
    using Literal = double;
    enum {
        IsComplex = 0,
        IsInteger = 0,
        IsSigned = 1,
        RequireInitialization = 1,
        ReadCost = 2,
        AddCost = 20,
        MulCost = 20
    };
};
