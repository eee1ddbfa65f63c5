#include "femoop/methods/mohr/point_results.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

using namespace femoop::mohr;

TEST_SUITE_BEGIN("femoop mohr");

namespace {

PointQuestion plane_stress() { return {.state = plane_state(Kind::PlaneStress, 80.0, -20.0, 50.0)}; }

} // namespace

TEST_CASE("A point's results agree with the circle: C = (x + y)/2, R = sqrt(((x - y)/2)^2 + xy^2), poles on its rim")
{
    const PointResults point = point_results(plane_stress());
    const double R = std::hypot(50.0, 50.0);
    CHECK(point.circle.centre == doctest::Approx(30.0));
    CHECK(point.circle.radius == doctest::Approx(R));
    CHECK(point.principal.first == doctest::Approx(30.0 + R));
    CHECK(*point.second_angle == doctest::Approx(*point.principal.angle - 0.5 * std::numbers::pi));
    CHECK(point.absolute_shear == doctest::Approx(R)); // the third principal value, 0, lies between
    for (const CirclePoint& pole : {point.pole_of_planes, point.pole_of_normals})
        CHECK(std::hypot(pole.normal - 30.0, pole.shear) == doctest::Approx(R));
}

TEST_CASE("Stresses of a strain are counted in the unit of E, whatever the strain counts in")
{
    PointQuestion question{.state = plane_state(Kind::Strain, 400.0, -100.0, 300.0), .strain_unit = 1e-6};
    question.state.E = 210e3;
    question.state.nu = 0.3;
    const PointResults point = point_results(question);
    REQUIRE(point.stress);
    CHECK(point.stress->x == doctest::Approx(210e3 / (1.0 - 0.09) * (400e-6 - 0.3 * 100e-6)));
    CHECK(point.principal_stress->values[0] + point.principal_stress->values[1] + point.principal_stress->values[2] ==
          doctest::Approx(point.stress->x + point.stress->y + point.stress->z));
}

TEST_CASE("A criterion judges a stress itself, and of a strain the stresses that follow from it")
{
    PointQuestion question = plane_stress();
    question.criterion = Criterion::Tresca;
    question.strength.fy = 250.0;
    CHECK(*point_results(question).safety->factor == doctest::Approx(250.0 / (2.0 * std::hypot(50.0, 50.0))));
    question.state = plane_state(Kind::Strain, 1e-3, 0.0, 0.0);
    question.state.E = 200e3;
    question.state.nu = 0.0;
    CHECK(*point_results(question).safety->factor == doctest::Approx(250.0 / 200.0));
    CHECK_FALSE(point_results(plane_stress()).safety);
}

TEST_CASE("Second moments of area have no third direction and no stress, and their shear points down")
{
    const PointResults point = point_results({.state = plane_state(Kind::Inertia, 9.0, 4.0, 2.0)});
    CHECK_FALSE(point.space);
    CHECK_FALSE(point.stress);
    CHECK(usual_rule(Kind::Inertia) == ShearRule::TensorDown);
    CHECK(usual_rule(Kind::Strain) == ShearRule::ClockwiseUp);
}

TEST_SUITE_END();
