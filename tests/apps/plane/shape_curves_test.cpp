#include <doctest/doctest.h>

#include <numbers>

#include "apps/plane/discretize/shape_curves.h"

using namespace femoop::plane;
using discretize::curves_of;
using discretize::ShapePart;
using doctest::Approx;

namespace {

constexpr double half_turn = std::numbers::pi;

DrawnPlace at(double x, double y) { return {.point = {}, .at = {x, y}}; }

std::vector<ShapePart> parts_of(const DrawnShape& shape)
{
    const PlaneModel model;
    discretize::ShapeCurves made = curves_of(model, shape, "c", 1e-9);
    REQUIRE(made.faults.empty());
    return std::move(made.parts);
}

double length_of(const std::vector<ShapePart>& parts)
{
    double sum = 0.0;
    for (const ShapePart& part : parts) sum += part.curve.length({});
    return sum;
}

} // namespace

TEST_CASE("An arc runs from its start over the place on it to its end, whichever way that is")
{
    const DrawnShape upper{.kind = DrawnKind::Arc, .places = {at(3, 0), at(0, 3), at(-3, 0)}};
    const DrawnShape lower{.kind = DrawnKind::Arc, .places = {at(3, 0), at(0, -3), at(-3, 0)}};
    CHECK(parts_of(upper).front().curve.at(0.5).y == Approx(3.0));
    CHECK(parts_of(lower).front().curve.at(0.5).y == Approx(-3.0));
    CHECK(length_of(parts_of(upper)) == Approx(3.0 * half_turn));
}

TEST_CASE("About a centre an arc turns counter-clockwise, unless it is said to turn clockwise")
{
    DrawnShape arc{.kind = DrawnKind::Arc, .places = {at(2, 0), at(0, 2)}, .center = at(0, 0)};
    CHECK(length_of(parts_of(arc)) == Approx(half_turn));
    arc.is_clockwise = true;
    CHECK(length_of(parts_of(arc)) == Approx(3.0 * half_turn));
}

TEST_CASE("A turned ellipse begins at the end of its first axis")
{
    const DrawnShape egg{.kind = DrawnKind::Ellipse, .center = at(1, 2), .axes = {3.0, 2.0}, .angle = 90.0};
    const ShapePart whole = parts_of(egg).front();
    CHECK(whole.ends[0].x == Approx(1.0));
    CHECK(whole.ends[0].y == Approx(5.0));
    CHECK(whole.curve.area({}, {0.0, 0.0}) == Approx(6.0 * half_turn));
    const DrawnShape half{.kind = DrawnKind::Ellipse,
                          .places = {at(1, 5), at(1, -1)},
                          .center = at(1, 2),
                          .axes = {3.0, 2.0},
                          .angle = 90.0};
    CHECK(length_of(parts_of(half)) == Approx(0.5 * whole.curve.length({})));
}

TEST_CASE("A spline goes through its places, and its curvature does not jump there")
{
    for (const bool is_closed : {false, true}) {
        const DrawnShape rope{.kind = DrawnKind::Spline,
                              .places = {at(0, 0), at(1, 2), at(3, 1), at(4, 4), at(2, 5)},
                              .is_closed = is_closed};
        const std::vector<ShapePart> parts = parts_of(rope);
        CHECK(parts.size() == (is_closed ? 5 : 4));
        for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
            const double h = distance(parts[i].ends[0], parts[i].ends[1]);
            const double k = distance(parts[i + 1].ends[0], parts[i + 1].ends[1]);
            const auto before = parts[i].curve.second_derivative(1.0),
                       after = parts[i + 1].curve.second_derivative(0.0);
            CHECK(before.x / (h * h) == Approx(after.x / (k * k))); // by the sum of chords
            CHECK(before.y / (h * h) == Approx(after.y / (k * k)));
        }
        if (!is_closed) CHECK(length(parts.front().curve.second_derivative(0.0)) == Approx(0.0)); // natural
    }
}

TEST_CASE("Places of a spline on a straight line leave it straight")
{
    const DrawnShape rope{.kind = DrawnKind::Spline, .places = {at(0, 0), at(1, 2), at(4, 8)}};
    CHECK(length_of(parts_of(rope)) == Approx(std::hypot(4.0, 8.0)));
}
