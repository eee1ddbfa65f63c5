#include "femoop/methods/mohr/space_construction.h"

#include <doctest/doctest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <random>

using namespace femoop::mohr;
using doctest::Approx;

TEST_SUITE_BEGIN("femoop mohr");

namespace {

constexpr SpaceState oblique_state{-19.0, 4.6, -8.3, -4.7, 11.8, 6.45};
const Eigen::Vector3d normal(0.3, -0.8, 0.4);

/// How far a point lies off an arc, along its radius.
double off(const ConstructionStep::Arc& arc, const CirclePoint& p)
{
    return std::hypot(p.normal - arc.centre.normal, p.shear) - arc.radius;
}

bool is_on(const ConstructionStep::Arc& arc, const CirclePoint& p)
{
    const double angle = std::atan2(p.shear, p.normal - arc.centre.normal);
    const double low = std::min(arc.start, arc.start + arc.sweep), high = std::max(arc.start, arc.start + arc.sweep);
    return std::abs(off(arc, p)) < 1e-9 && angle > low - 1e-6 && angle < high + 1e-6;
}

} // namespace

TEST_CASE("The arcs of a plane's angles with directions 1 and 3 meet in its point")
{
    std::mt19937 random(7);
    std::normal_distribution<double> part;
    const SpacePrincipal p = principal(oblique_state);
    for (int i = 0; i < 500; ++i) {
        const Eigen::Vector3d n(part(random), part(random), part(random));
        const auto steps = construction(p, n);
        REQUIRE(steps.size() == 9);
        const CirclePoint at = steps[8].points.front().at;
        CHECK(is_on(steps[6].arcs.front(), at));
        CHECK(is_on(steps[7].arcs.front(), at));
        const OnPlane on = on_plane(oblique_state, n);
        CHECK(at.normal == Approx(on.normal_component));
        CHECK(at.shear == Approx(on.shear));
    }
}

TEST_CASE("The line from a principal value leans from the upright by the normal's angle with its direction")
{
    const SpacePrincipal p = principal(oblique_state);
    const auto steps = construction(p, normal);
    const auto lean = [](const ConstructionStep::Line& line) {
        return std::atan2(std::abs(line.to.normal - line.from.normal), line.to.shear - line.from.shear);
    };
    CHECK(lean(steps[6].lines.front()) == Approx(angle_with(p, 0, normal)));
    CHECK(lean(steps[7].lines.front()) == Approx(angle_with(p, 2, normal)));
    const Eigen::Vector3d n = normal.normalized();
    CHECK(std::cos(angle_with(p, 0, normal)) == Approx(std::abs(n.dot(p.directions.col(0)))));
}

TEST_CASE("A line's other points lie on the circles that share its principal value")
{
    const SpacePrincipal p = principal(oblique_state);
    const auto [largest, upper, lower] = circles(p);
    const auto steps = construction(p, normal);
    const auto distance = [](const Circle& c, const CirclePoint& at) {
        return std::hypot(at.normal - c.centre, at.shear) - c.radius;
    };
    CHECK(distance(largest, steps[6].points[0].at) == Approx(0.0).epsilon(1e-12));
    CHECK(distance(upper, steps[6].points[1].at) == Approx(0.0).epsilon(1e-12));
    CHECK(distance(largest, steps[7].points[0].at) == Approx(0.0).epsilon(1e-12));
    CHECK(distance(lower, steps[7].points[1].at) == Approx(0.0).epsilon(1e-12));
}

TEST_CASE("A state of three equal values is a point and equal pairs still lead to the plane's point")
{
    CHECK(construction(principal(SpaceState{5.0, 5.0, 5.0}), normal).back().stage == ConstructionStage::Point);
    for (const SpaceState& s : {SpaceState{9.0, 9.0, -4.0}, SpaceState{9.0, -4.0, -4.0}}) {
        const auto steps = construction(principal(s), normal);
        const CirclePoint at = steps.back().points.front().at;
        CHECK(std::abs(off(steps[6].arcs.front(), at)) < 1e-9);
        CHECK(std::abs(off(steps[7].arcs.front(), at)) < 1e-9);
    }
}

TEST_CASE("Principal values and directions make the state again")
{
    const SpacePrincipal p = principal(oblique_state);
    const SpaceState again = from_principal(p);
    CHECK((tensor(again) - tensor(oblique_state)).norm() == Approx(0.0).epsilon(1e-12));
}

TEST_CASE("A principal direction can be chosen and the others stay square to it and right-handed")
{
    const SpacePrincipal p = principal(oblique_state);
    for (int i = 0; i < 3; ++i)
        for (const Eigen::Vector3d& along : {Eigen::Vector3d(0.0, 0.0, 5.0), Eigen::Vector3d(1.0, -2.0, 0.3),
                                             Eigen::Vector3d(p.directions.col((i + 1) % 3))}) {
            const SpacePrincipal turned = with_direction(p, i, along);
            CHECK(turned.directions.col(i).dot(along.normalized()) == Approx(1.0));
            CHECK((turned.directions.transpose() * turned.directions - Eigen::Matrix3d::Identity()).norm() < 1e-12);
            CHECK(turned.directions.determinant() == Approx(1.0));
            CHECK(principal(from_principal(turned)).values[0] == Approx(p.values[0]));
        }
}

TEST_SUITE_END();
