#include "femoop/methods/mohr/plane_state.h"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/femoop/methods/mohr/degree.h"

using namespace femoop::mohr;
using doctest::Approx;

TEST_SUITE_BEGIN("femoop mohr");

namespace {

using std::numbers::pi;
constexpr PlaneState hibbeler{-20.0, 90.0, 60.0}; // Mechanics of Materials, example 9.3: 116, -46.4 MPa at 66.3 degrees

/// Turned by the matrix product Q T Q^T, whose rows are the new axes.
Eigen::Matrix2d turned(const PlaneState& state, double angle)
{
    const Eigen::Matrix2d Q =
        (Eigen::Matrix2d() << std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle)).finished();
    return Q * tensor(state) * Q.transpose();
}

} // namespace

TEST_CASE("A published plane stress has the principal stresses and directions of its book")
{
    const PlanePrincipal p = principal(hibbeler);
    CHECK(p.first == Approx(35.0 + std::sqrt(55.0 * 55.0 + 60.0 * 60.0)).epsilon(1e-15));
    CHECK(p.second == Approx(35.0 - std::sqrt(55.0 * 55.0 + 60.0 * 60.0)).epsilon(1e-15));
    REQUIRE(p.angle);
    CHECK(*p.angle / degree == Approx(66.25522354).epsilon(1e-9));
    CHECK(circle(hibbeler).centre == 35.0);
}

TEST_CASE("Turning the axes is the matrix product with their directions")
{
    for (const double angle : {-2.0, -30.0 * degree, 0.1, 0.7, 2.5}) {
        CAPTURE(angle);
        const PlaneState found = rotated({-80.0, 50.0, -25.0}, angle);
        CHECK(tensor(found).isApprox(turned({-80.0, 50.0, -25.0}, angle), 1e-14));
    }
}

TEST_CASE("Axes turned there and back give the state they began with")
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> component(-100.0, 100.0), angle(-7.0, 7.0);
    for (int i = 0; i < 1000; ++i) {
        const PlaneState state{component(random), component(random), component(random)};
        const double turn = angle(random);
        CHECK((tensor(rotated(rotated(state, turn), -turn)) - tensor(state)).cwiseAbs().maxCoeff() < 1e-12);
    }
}

TEST_CASE("A quarter turn swaps the normal components and turns the shear's sign without any rounding")
{
    CHECK(rotated({-80.0, 50.0, -25.0}, 0.5 * pi) == PlaneState{50.0, -80.0, 25.0});
}

TEST_CASE("In the first principal direction the first value stands and no shear")
{
    const PlanePrincipal p = principal(hibbeler);
    const PlaneState there = rotated(hibbeler, *p.angle);
    CHECK(there.x == Approx(p.first));
    CHECK(there.y == Approx(p.second));
    CHECK(std::abs(there.xy) < 1e-13);
    const PlaneState back = from_principal(p.first, p.second, *p.angle);
    CHECK(back.x == Approx(hibbeler.x));
    CHECK(back.xy == Approx(hibbeler.xy));
}

TEST_CASE("In the direction of largest shear the shear is the radius and both normal components are the centre")
{
    const PlaneState there = rotated(hibbeler, *largest_shear_angle(hibbeler));
    CHECK(there.xy == Approx(circle(hibbeler).radius));
    CHECK(there.x == Approx(35.0));
    CHECK(there.y == Approx(35.0));
}

TEST_CASE("Principal values of 100 000 random plane tensors are Eigen's and their sum and product are the invariants")
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> digit(-1.0, 1.0), exponent(-90.0, 90.0);
    for (int i = 0; i < 100'000; ++i) {
        const double scale = std::pow(10.0, exponent(random));
        const PlaneState state{scale * digit(random), scale * digit(random), scale * digit(random)};
        const PlanePrincipal p = principal(state);
        const Eigen::Vector2d eigen = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(tensor(state)).eigenvalues();
        REQUIRE(std::abs(p.first - eigen[1]) < 1e-14 * scale);
        REQUIRE(std::abs(p.second - eigen[0]) < 1e-14 * scale);
        REQUIRE(std::abs(p.first + p.second - state.x - state.y) < 1e-14 * scale);
    }
}

TEST_CASE("A principal value that nearly vanishes keeps its digits")
{
    // det = 1e8 * 1e-8 - 0.25 = 0.75, so the second value is 0.75 / 1e8 to sixteen digits
    const PlanePrincipal p = principal(PlaneState{1e8, 1e-8, 0.5});
    CHECK(p.second == Approx(7.5e-9).epsilon(1e-14));
}

TEST_CASE("A point circle has no principal direction and the smallest shear gives it one")
{
    CHECK_FALSE(principal(PlaneState{7.0, 7.0, 0.0}).angle);
    CHECK_FALSE(largest_shear_angle({7.0, 7.0, 0.0}));
    CHECK(principal(PlaneState{7.0, 7.0, 0.0}).first == 7.0);
    CHECK_FALSE(principal(PlaneState{0.0, 0.0, 0.0}).angle);
    CHECK(*principal(PlaneState{7.0, 7.0, 1e-30}).angle == Approx(0.25 * pi));
}

TEST_CASE("Degenerate states have their directions exactly: uniaxial along x or y and pure shear of either sign")
{
    CHECK(*principal(PlaneState{30.0, 0.0, 0.0}).angle == 0.0);
    CHECK(principal(PlaneState{30.0, 0.0, 0.0}).second == 0.0);
    CHECK(*principal(PlaneState{0.0, 30.0, 0.0}).angle == 0.5 * pi);
    CHECK(*principal(PlaneState{0.0, 30.0, -0.0}).angle == 0.5 * pi);
    CHECK(*principal(PlaneState{0.0, 0.0, 20.0}).angle == 0.25 * pi);
    CHECK(*principal(PlaneState{0.0, 0.0, -20.0}).angle == -0.25 * pi);
    CHECK(principal(PlaneState{0.0, 0.0, -20.0}).second == -20.0);
}

TEST_CASE("The circle of huge and of tiny components is the same circle in another unit")
{
    for (const double scale : {1e-300, 1e-100, 1e100, 1e300}) {
        CAPTURE(scale);
        const PlanePrincipal p = principal(PlaneState{scale * -20.0, scale * 90.0, scale * 60.0});
        CHECK(p.first / scale == Approx(116.394102980498531).epsilon(1e-14));
        CHECK(p.second / scale == Approx(-46.394102980498531).epsilon(1e-14));
        CHECK(*p.angle / degree == Approx(66.25522354).epsilon(1e-9));
    }
}

TEST_CASE("Shear that turns the element clockwise is up: face x of a positive shear lies below the axis")
{
    CHECK(face_point(hibbeler, 0.0, ShearRule::ClockwiseUp).shear == -60.0);
    CHECK(face_point(hibbeler, 0.5 * pi, ShearRule::ClockwiseUp).shear == 60.0);
    CHECK(face_point(hibbeler, 0.0, ShearRule::TensorDown).shear == 60.0);
    CHECK(pole(hibbeler, ShearRule::ClockwiseUp).normal == -20.0);
    CHECK(pole(hibbeler, ShearRule::ClockwiseUp).shear == 60.0);
    CHECK(pole(hibbeler, ShearRule::TensorDown).shear == -60.0);
}

TEST_CASE("A face that turns moves its point on the circle by twice the angle the same way")
{
    const Circle c = circle(hibbeler);
    const auto angle_of = [&](double face) {
        const CirclePoint p = face_point(hibbeler, face, ShearRule::ClockwiseUp);
        return std::atan2(p.shear, p.normal - c.centre);
    };
    const double turned = std::remainder(angle_of(0.3) - angle_of(0.0), 2.0 * pi);
    CHECK(turned == Approx(0.6));
}

TEST_CASE("The line from the pole of planes to a point of the circle is parallel to that point's plane")
{
    for (const PoleOf of : {PoleOf::Planes, PoleOf::Normals})
        for (double angle = -1.5; angle < 1.5; angle += 0.37) {
            CAPTURE(angle);
            const CirclePoint from = pole(hibbeler, ShearRule::ClockwiseUp, of);
            const CirclePoint to = face_point(hibbeler, angle, ShearRule::ClockwiseUp);
            const double line = std::atan2(to.shear - from.shear, to.normal - from.normal);
            const double expected = of == PoleOf::Planes ? angle + 0.5 * pi : angle;
            CHECK(std::abs(as_direction(line - expected)) < 1e-12);
        }
}

TEST_SUITE_END();
