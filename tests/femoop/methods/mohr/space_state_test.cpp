#include "femoop/methods/mohr/space_state.h"

#include <doctest/doctest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <random>

using namespace femoop::mohr;
using doctest::Approx;

TEST_SUITE_BEGIN("femoop mohr");

namespace {

/// Ugural & Fenster, Advanced Mechanics of Materials and Applied Elasticity, example 1.6: 11.618, -9.001, -25.316
constexpr SpaceState ugural{-19.0, 4.6, -8.3, -4.7, 11.8, 6.45};

Eigen::Matrix3d random_turn(std::mt19937& random)
{
    std::normal_distribution<double> part;
    return Eigen::Quaterniond(part(random), part(random), part(random), part(random)).normalized().toRotationMatrix();
}

Eigen::Vector3d vector(const std::array<double, 3>& values) { return {values[0], values[1], values[2]}; }

void check_principal(const Eigen::Matrix3d& T)
{
    const double scale = T.cwiseAbs().maxCoeff();
    const SpacePrincipal p = principal(from_tensor(T));
    const Eigen::Vector3d eigen = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(T).eigenvalues().reverse();
    REQUIRE((vector(p.values) - eigen).cwiseAbs().maxCoeff() <= 4e-15 * scale);
    const Eigen::Matrix3d& V = p.directions;
    REQUIRE((V.transpose() * V - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < 4e-15);
    REQUIRE(V.determinant() > 0.0);
    REQUIRE((T * V - V * vector(p.values).asDiagonal()).cwiseAbs().maxCoeff() <= 8e-15 * scale);
}

} // namespace

TEST_CASE("A published stress in space has its book's principal stresses and direction and invariants")
{
    const SpacePrincipal p = principal(ugural);
    CHECK(p.values[0] == Approx(11.61780137).epsilon(1e-9));
    CHECK(p.values[1] == Approx(-9.001513053).epsilon(1e-9));
    CHECK(p.values[2] == Approx(-25.31628832).epsilon(1e-9));
    CHECK(p.directions(1, 0) == Approx(0.8638013179).epsilon(1e-9));
    CHECK(absolute_largest_shear(p) == Approx(18.46704484).epsilon(1e-9));
    const Invariants i = invariants(ugural);
    CHECK(i.I1 == Approx(-22.7));
    CHECK(i.I2 == Approx(-170.8125));
    CHECK(i.I3 == Approx(2647.521));
}

TEST_CASE("Principal values and directions of 100 000 random tensors are Eigen's, tiny and huge ones too")
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> digit(-1.0, 1.0), exponent(-90.0, 90.0);
    for (int i = 0; i < 100'000; ++i) {
        Eigen::Matrix3d T = Eigen::Matrix3d::NullaryExpr([&] { return digit(random); });
        T = (T + T.transpose()).eval() * std::pow(10.0, exponent(random));
        check_principal(T);
    }
}

TEST_CASE("Repeated principal values in turned axes come out equal to rounding with orthonormal directions")
{
    std::mt19937 random(9);
    for (const Eigen::Vector3d& values : {Eigen::Vector3d(5.0, 5.0, -3.0), Eigen::Vector3d(7.0, 2.0, 2.0),
                                          Eigen::Vector3d(4.0, 4.0, 4.0), Eigen::Vector3d(1.0, 1.0 - 1e-14, 0.0)})
        for (int i = 0; i < 1000; ++i) {
            const Eigen::Matrix3d Q = random_turn(random);
            Eigen::Matrix3d T = Q * values.asDiagonal() * Q.transpose();
            T = (0.5 * (T + T.transpose())).eval();
            check_principal(T);
            REQUIRE((vector(principal(from_tensor(T)).values) - values).cwiseAbs().maxCoeff() < 2e-14);
        }
}

TEST_CASE("A diagonal tensor has its own components as principal values without any rounding")
{
    CHECK(principal({.x = 0.1, .y = 0.3, .z = 0.1}).values == std::array{0.3, 0.1, 0.1});
    CHECK(principal(SpaceState{}).values == std::array{0.0, 0.0, 0.0});
    CHECK(principal({.x = 5e-324, .y = 1e-310, .z = 0.0}).values == std::array{1e-310, 5e-324, 0.0});
}

TEST_CASE("Invariants are those of the principal values and no turn of the axes changes them")
{
    std::mt19937 random(2);
    const Invariants expected = invariants(ugural);
    for (int i = 0; i < 100; ++i) {
        const Eigen::Matrix3d Q = random_turn(random);
        const SpaceState turned = from_tensor(Q * tensor(ugural) * Q.transpose());
        const Invariants found = invariants(turned);
        CHECK(found.I1 == Approx(expected.I1));
        CHECK(found.I2 == Approx(expected.I2));
        CHECK(found.I3 == Approx(expected.I3));
    }
    const auto s = principal(ugural).values;
    CHECK(s[0] + s[1] + s[2] == Approx(expected.I1));
    CHECK(s[0] * s[1] + s[1] * s[2] + s[2] * s[0] == Approx(expected.I2));
    CHECK(s[0] * s[1] * s[2] == Approx(expected.I3));
}

TEST_CASE("On the plane square to a principal direction stands its value alone")
{
    const SpacePrincipal p = principal(ugural);
    for (int i = 0; i < 3; ++i) {
        const OnPlane on = on_plane(ugural, 3.0 * p.directions.col(i));
        CHECK(on.normal_component == Approx(p.values[static_cast<std::size_t>(i)]));
        CHECK(on.shear == 0.0);
        CHECK_FALSE(on.shear_direction);
    }
}

TEST_CASE("The octahedral plane carries the mean and the octahedral shear")
{
    const SpacePrincipal p = principal(ugural);
    const Deviator d = deviator(p);
    const OnPlane on = on_plane(ugural, p.directions * Eigen::Vector3d::Ones());
    CHECK(on.normal_component == Approx(d.mean));
    CHECK(on.shear == Approx(d.octahedral_shear));
    CHECK(d.octahedral_shear == Approx(std::sqrt(2.0 * d.J2 / 3.0)));
    CHECK(d.equivalent == Approx(std::sqrt(3.0 * d.J2)));
    const Invariants i = invariants(ugural);
    CHECK(d.J2 == Approx(i.I1 * i.I1 / 3.0 - i.I2));
    CHECK(d.J3 == Approx(2.0 * i.I1 * i.I1 * i.I1 / 27.0 - i.I1 * i.I2 / 3.0 + i.I3));
}

TEST_CASE("Every plane's point lies inside the largest circle and outside the two small ones")
{
    const auto c = circles(principal(ugural));
    std::mt19937 random(4);
    for (int i = 0; i < 1000; ++i) {
        const OnPlane on = on_plane(ugural, random_turn(random).col(0));
        const auto distance = [&](const Circle& circle) {
            return std::hypot(on.normal_component - circle.centre, on.shear) - circle.radius;
        };
        CHECK(distance(c[0]) < 1e-12);
        CHECK(distance(c[1]) > -1e-12);
        CHECK(distance(c[2]) > -1e-12);
    }
}

TEST_CASE("Lode's angle is 0 in axial tension, 30 degrees in pure shear, 60 in axial compression, none of a mean alone")
{
    const auto lode = [](const SpaceState& state) { return deviator(principal(state)).lode; };
    CHECK(*lode({.x = 3.0}) == 0.0);
    CHECK(*lode({.xy = 3.0}) == Approx(std::numbers::pi / 6.0));
    CHECK(*lode({.x = -3.0}) == Approx(std::numbers::pi / 3.0));
    CHECK_FALSE(lode({.x = 3.0, .y = 3.0, .z = 3.0}));
    const Deviator d = deviator(principal(ugural));
    CHECK(std::cos(3.0 * *d.lode) == Approx(1.5 * std::sqrt(3.0) * d.J3 / std::pow(d.J2, 1.5)));
}

TEST_SUITE_END();
