#pragma once

#include <string>
#include <vector>

#include "femoop/result/curve.h"

namespace femoop {

/// A result along a stretch of a member as a formula: M(x) = c0 + c1 x + c2 x^2 + ..., x from the member's first end.
struct Expression {
    double from = 0.0, to = 0.0;      ///< the stretch
    std::vector<double> coefficients; ///< of 1, x, x^2 ...; what rounding alone left is 0, and the last one is not
    bool is_series = false;           ///< on an elastic foundation: a power series, cut where it no longer changes
};

/// p(x - from), from one place of a member of this length to another.
Expression expression(const Polynomial& p, double from, double to, double length);

/// Whether two neighbours on a member of this length are one formula, but for rounding; series never are.
bool go_on(const Expression& a, const Expression& b, double length);

/// The formulas of a component from load point to load point; neighbours that go on by the same formula are one.
std::vector<Expression> expressions(const Curve& curve, MemberComponent component);

/// "-42.68 + 50.6 x - 6.328 x²" with so many significant digits; "0" for a stretch of zero. The unit of x is the
/// model's length.
std::string text(const Expression& expression, int digits = 4);

} // namespace femoop
