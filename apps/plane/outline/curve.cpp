#include "apps/plane/outline/curve.h"

#include <algorithm>
#include <cmath>

namespace outline {

using femoop::Quantity;
using femoop::plane::DrawnKind;
using femoop::plane::DrawnPlace;
using femoop::plane::DrawnShape;

namespace {

constexpr double whole_turn = 2.0 * std::numbers::pi;
constexpr double roundoff = 1e-12; // of a curve's size
constexpr double rounding = 1e-6;  // of a turn that a file writes with few digits

std::vector<Place> moved(std::vector<Place> places, const Affine& map)
{
    for (Place& place : places) place = map * place;
    return places;
}

struct Mapping {
    const Affine& map;

    Curve operator()(const Polyline& line) const { return Polyline{moved(line.places, map), line.is_closed}; }
    Curve operator()(const EllipticArc& arc) const
    {
        return EllipticArc{map * arc.center, map.linear() * arc.u, map.linear() * arc.v, arc.from, arc.to};
    }
    Curve operator()(const CubicChain& chain) const { return CubicChain{moved(chain.places, map)}; }
    Curve operator()(const SplineThrough& spline) const
    {
        return SplineThrough{moved(spline.places, map), spline.is_closed};
    }
};

DrawnPlace drawn(const Place& place) { return {std::nullopt, {Quantity(place.x()), Quantity(place.y())}}; }

std::vector<DrawnPlace> drawn(const std::vector<Place>& places)
{
    std::vector<DrawnPlace> all;
    for (const Place& place : places) all.push_back(drawn(place));
    return all;
}

std::vector<Place> without_repeats(const std::vector<Place>& places)
{
    std::vector<Place> kept;
    for (const Place& place : places)
        if (kept.empty() || place != kept.back()) kept.push_back(place);
    return kept;
}

struct Drawing {
    std::vector<DrawnShape> operator()(const Polyline& line) const
    {
        return through(DrawnKind::Line, line.places, line.is_closed, 2);
    }
    std::vector<DrawnShape> operator()(const SplineThrough& spline) const
    {
        return through(DrawnKind::Spline, spline.places, spline.is_closed, 3);
    }
    std::vector<DrawnShape> operator()(const CubicChain& chain) const
    {
        const bool has_length = std::ranges::any_of(chain.places, [&](const Place& p) { return p != chain.places[0]; });
        if (chain.places.size() < 4 || !has_length) return {};
        return {{.kind = DrawnKind::Bezier, .places = drawn(chain.places)}};
    }
    std::vector<DrawnShape> operator()(const EllipticArc& arc) const;

private:
    static std::vector<DrawnShape> through(DrawnKind kind, const std::vector<Place>& places, bool is_closed,
                                           std::size_t n_least)
    {
        std::vector<Place> kept = without_repeats(places);
        if (kept.size() > 3 && kept.front() == kept.back()) is_closed = true;
        if (is_closed && kept.size() > 1 && kept.front() == kept.back()) kept.pop_back();
        if (kept.size() == 2) kind = DrawnKind::Line;
        if (kept.size() < std::min<std::size_t>(n_least, 2)) return {};
        return {{.kind = kind, .places = drawn(kept), .is_closed = is_closed && kept.size() > 2}};
    }
};

/// The half axes of an ellipse, the longer first.
/// Source  Rytz; tan 2t = 2 u.v / (u.u - v.v) for the t at which place and tangent are square to one another
EllipticArc on_its_axes(const EllipticArc& arc)
{
    const double turn = 0.5 * std::atan2(2.0 * arc.u.dot(arc.v), arc.u.squaredNorm() - arc.v.squaredNorm());
    return {.center = arc.center,
            .u = std::cos(turn) * arc.u + std::sin(turn) * arc.v,
            .v = std::cos(turn) * arc.v - std::sin(turn) * arc.u,
            .from = arc.from - turn,
            .to = arc.to - turn};
}

Place place_on(const EllipticArc& arc, double t) { return arc.center + std::cos(t) * arc.u + std::sin(t) * arc.v; }

std::vector<DrawnShape> Drawing::operator()(const EllipticArc& arc) const
{
    const EllipticArc own = on_its_axes(arc);
    const double a = own.u.norm(), b = own.v.norm();
    const bool is_whole = std::abs(arc.to - arc.from) >= whole_turn - rounding;
    const std::vector<Place> ends{place_on(arc, arc.from), place_on(arc, arc.to)};
    if (!(b > roundoff * a)) return (*this)(Polyline{ends, false}); // seen from the side
    const bool is_circle = a - b <= 1e-9 * a;
    if (is_whole && is_circle)
        return {
            {.kind = DrawnKind::Circle, .places = {}, .center = drawn(arc.center), .radius = Quantity(0.5 * (a + b))}};
    DrawnShape shape{
        .kind = is_circle ? DrawnKind::Arc : DrawnKind::Ellipse, .places = {}, .center = drawn(arc.center)};
    if (!is_circle) {
        shape.axes = {Quantity(a), Quantity(b)};
        if (const double angle = std::atan2(own.u.y(), own.u.x()) * 180.0 / std::numbers::pi; angle != 0.0)
            shape.angle = Quantity(angle);
    }
    if (is_whole) return {shape};
    if ((ends[0] - ends[1]).norm() <= roundoff * a) return {};
    shape.places = drawn(ends);
    const bool turns_left = arc.u.x() * arc.v.y() - arc.u.y() * arc.v.x() > 0.0;
    if (turns_left != (arc.to > arc.from)) shape.is_clockwise = true;
    return {shape};
}

} // namespace

std::array<Place, 4> raised(const std::array<Place, 3>& quadratic)
{
    const auto& [a, b, c] = quadratic;
    return {a, a + 2.0 / 3.0 * (b - a), c + 2.0 / 3.0 * (b - c), c};
}

Curve mapped(const Curve& curve, const Affine& map) { return std::visit(Mapping{map}, curve); }

std::vector<DrawnShape> shapes_of(const Curve& curve) { return std::visit(Drawing{}, curve); }

} // namespace outline
