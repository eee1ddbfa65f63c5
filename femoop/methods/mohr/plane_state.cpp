#include "femoop/methods/mohr/plane_state.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "femoop/methods/mohr/rounding.h"

namespace femoop::mohr {

namespace {

using std::numbers::pi;

double positive_zero(double value) { return value + 0.0; }

double half_difference(const PlaneState& state) { return sum_of({0.5 * state.x, -0.5 * state.y}); }

/// a b - c d with one rounding of each product made good, after Kahan; 0 where the factors' own rounding is left alone.
double difference_of_products(double a, double b, double c, double d)
{
    const double cd = c * d;
    const double error = std::fma(-c, d, cd);
    return without_rounding(std::fma(a, b, -cd) + error, std::abs(a * b) + std::abs(cd));
}

/// The exponent that brings the largest component near 1, so that products neither overflow nor vanish.
int exponent(const PlaneState& state)
{
    int power = 0;
    static_cast<void>(std::frexp(std::max({std::abs(state.x), std::abs(state.y), std::abs(state.xy)}), &power));
    return power;
}

struct Turn {
    double cos = 1.0, sin = 0.0;
};

/// Cosine and sine; what is rounding alone is 0, so that a quarter turn swaps the components exactly.
Turn exact_turn(double angle)
{
    constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();
    Turn t{std::cos(angle), std::sin(angle)};
    if (std::abs(t.cos) <= rounding) t = {0.0, std::copysign(1.0, t.sin)};
    else if (std::abs(t.sin) <= rounding) t = {std::copysign(1.0, t.cos), 0.0};
    return t;
}

} // namespace

double as_direction(double angle)
{
    const double reduced = std::remainder(angle, pi); // in [-pi/2, pi/2]
    return reduced <= -0.5 * pi ? reduced + pi : positive_zero(reduced);
}

Circle circle(const PlaneState& state)
{
    return {sum_of({0.5 * state.x, 0.5 * state.y}), std::hypot(half_difference(state), state.xy)};
}

PlanePrincipal principal(const PlaneState& state)
{
    const int power = exponent(state);
    const PlaneState s{std::ldexp(state.x, -power), std::ldexp(state.y, -power), std::ldexp(state.xy, -power)};
    const auto [centre, radius] = circle(s);
    // The root of larger size is a sum without cancellation; the other follows from the product of both.
    const double outer = centre >= 0.0 ? centre + radius : centre - radius;
    const double inner = outer == 0.0 ? 0.0 : difference_of_products(s.x, s.y, s.xy, s.xy) / outer;
    PlanePrincipal result{positive_zero(std::ldexp(std::max(outer, inner), power)),
                          positive_zero(std::ldexp(std::min(outer, inner), power))};
    if (radius > 0.0) result.angle = as_direction(0.5 * std::atan2(positive_zero(s.xy), half_difference(s)));
    return result;
}

std::optional<double> largest_shear_angle(const PlaneState& state)
{
    const auto angle = principal(state).angle;
    if (!angle) return std::nullopt;
    return as_direction(sum_of({*angle, -0.25 * pi}));
}

PlaneState rotated(const PlaneState& state, double angle)
{
    const auto [c, s] = exact_turn(2.0 * angle);
    if (s == 0.0 && c > 0.0) return {positive_zero(state.x), positive_zero(state.y), positive_zero(state.xy)};
    if (s == 0.0) return {positive_zero(state.y), positive_zero(state.x), positive_zero(-state.xy)};
    const double centre = circle(state).centre, a = half_difference(state);
    const double along = sum_of({a * c, state.xy * s}), across = sum_of({state.xy * c, -a * s});
    const double largest = std::max({std::abs(state.x), std::abs(state.y), std::abs(state.xy)});
    const auto clean = [&](double value) { return without_rounding(value, largest); };
    return {clean(centre + along), clean(centre - along), clean(across)};
}

PlaneState from_principal(double first, double second, double angle) { return rotated({first, second, 0.0}, -angle); }

CirclePoint face_point(const PlaneState& state, double angle, ShearRule rule)
{
    const PlaneState face = rotated(state, angle);
    return {face.x, rule == ShearRule::ClockwiseUp ? positive_zero(-face.xy) : face.xy};
}

CirclePoint pole(const PlaneState& state, ShearRule rule, PoleOf of)
{
    const CirclePoint up = of == PoleOf::Planes ? CirclePoint{state.x, state.xy} : CirclePoint{state.y, -state.xy};
    return {positive_zero(up.normal), positive_zero(rule == ShearRule::ClockwiseUp ? up.shear : -up.shear)};
}

Eigen::Matrix2d tensor(const PlaneState& state)
{
    return (Eigen::Matrix2d() << state.x, state.xy, state.xy, state.y).finished();
}

} // namespace femoop::mohr
