#include "femoop/material/linear_elastic.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <array>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

using namespace femoop;

namespace {

constexpr double E = 71.0e3, nu = 0.27, alpha = 2.3e-5;
constexpr std::array all_states{StressState::PlaneStress, StressState::PlaneStrain, StressState::Axisymmetric,
                                StressState::Solid};

Eigen::MatrixXd stiffness(StressState state, double poisson = nu)
{
    return LinearElastic({.E = E, .nu = poisson}, state).tangent({});
}

/// D of the components that remain where the stresses of all others are zero.
Eigen::MatrixXd condensed(const Eigen::MatrixXd& D, const std::vector<int>& kept, const std::vector<int>& released)
{
    return D(kept, kept) - D(kept, released) * D(released, released).inverse() * D(released, kept);
}

void check_equal(const Eigen::MatrixXd& found, const Eigen::MatrixXd& expected)
{
    CHECK((found - expected).norm() <= 1e-14 * expected.norm());
}

std::string refusal(const ElasticConstants& constants, StressState state)
{
    const std::optional<ElasticFault> fault = why_not_elastic(constants, state);
    return fault ? message(*fault) : "";
}

} // namespace

TEST_SUITE("linear elastic")
{
    TEST_CASE("The stiffness is symmetric and positive definite in every state, for every Poisson's ratio")
    {
        for (const StressState state : all_states)
            for (const double poisson : {-0.99, -0.4, 0.0, 0.27, 0.4999}) {
                const Eigen::MatrixXd D = stiffness(state, poisson);
                CHECK(D == D.transpose());
                CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(D).eigenvalues().minCoeff() > 0.0);
            }
    }

    TEST_CASE("Stress along one axis alone stretches by s / E and narrows by nu s / E")
    {
        for (const StressState state : {StressState::PlaneStress, StressState::Axisymmetric, StressState::Solid})
            for (const int axis : {0, 1}) {
                const int n = n_components(state);
                const double s = 13.0;
                const Eigen::VectorXd strain = stiffness(state).inverse() * (s * Eigen::VectorXd::Unit(n, axis));
                CHECK(strain[axis] == doctest::Approx(s / E));
                CHECK(strain[1 - axis] == doctest::Approx(-nu * s / E));
            }
    }

    TEST_CASE("Shear turns the right angle by t / G, G = E / 2 (1 + nu)")
    {
        for (const StressState state : all_states) {
            const int xy = state == StressState::PlaneStress ? 2 : 3;
            CHECK(stiffness(state)(xy, xy) == doctest::Approx(E / (2.0 * (1.0 + nu))));
            CHECK(stiffness(state).row(xy).sum() == stiffness(state)(xy, xy));
        }
    }

    TEST_CASE("Plane stress is the solid without stress out of the plane")
    {
        check_equal(stiffness(StressState::PlaneStress),
                    condensed(stiffness(StressState::Solid), {0, 1, 3}, {2, 4, 5}));
    }

    TEST_CASE("Plane strain and axisymmetry are the solid without shear out of the plane")
    {
        const Eigen::MatrixXd expected = stiffness(StressState::Solid).topLeftCorner(4, 4);
        check_equal(stiffness(StressState::PlaneStrain), expected);
        check_equal(stiffness(StressState::Axisymmetric), expected);
    }

    TEST_CASE("In plane strain sz = nu (sx + sy)")
    {
        const LinearElastic material({.E = E, .nu = nu}, StressState::PlaneStrain);
        const StressVector s = material.stress({.strain = Eigen::Vector4d(3e-4, -5e-4, 0.0, 7e-4)});
        CHECK(s[2] == doctest::Approx(nu * (s[0] + s[1])));
    }

    TEST_CASE("Equal pressure all round shrinks the volume by p / K, K = E / 3 (1 - 2 nu)")
    {
        Eigen::VectorXd stress = Eigen::VectorXd::Zero(6);
        stress.head(3).setConstant(-17.0);
        const Eigen::VectorXd strain = stiffness(StressState::Solid).inverse() * stress;
        CHECK(strain.head(3).sum() == doctest::Approx(-17.0 * 3.0 * (1.0 - 2.0 * nu) / E));
    }

    TEST_CASE("A free body that is warmed stretches alike every way and does not shear")
    {
        for (const StressState state : all_states) {
            const LinearElastic material({.E = E, .nu = nu, .alpha = alpha}, state);
            const StrainVector strain = material.thermal_strain(40.0);
            for (std::size_t i = 0; i < components(state).size(); ++i)
                CHECK(strain[static_cast<int>(i)] == (components(state)[i] <= StressComponent::z ? alpha * 40.0 : 0.0));
        }
    }

    TEST_CASE("Components are named in the order of their vectors")
    {
        CHECK(components(StressState::PlaneStress).size() == 3);
        CHECK(name(components(StressState::PlaneStress)[2]) == "txy");
        CHECK(strain_name(components(StressState::Axisymmetric)[3]) == "gxy");
        for (const StressState state : all_states)
            CHECK(components(state).size() == static_cast<std::size_t>(n_components(state)));
    }

    TEST_CASE("Constants that no body has are refused in words")
    {
        CHECK(refusal({.E = 0.0, .nu = nu}, StressState::Solid) == "E is 0, which is not a positive stress");
        CHECK(refusal({.E = std::numeric_limits<double>::infinity(), .nu = nu}, StressState::Solid) != "");
        CHECK(refusal({.E = E, .nu = -1.0}, StressState::Solid) == "nu is -1, which is not above -1 and at most 0.5");
        CHECK(refusal({.E = E, .nu = 0.6}, StressState::PlaneStress) != "");
        CHECK(refusal({.E = E, .nu = std::numeric_limits<double>::quiet_NaN()}, StressState::Solid) != "");
        CHECK(refusal({.E = E, .nu = nu}, StressState::Solid) == "");
    }

    TEST_CASE("An incompressible body is refused except in plane stress")
    {
        for (const StressState state : {StressState::PlaneStrain, StressState::Axisymmetric, StressState::Solid}) {
            CHECK(refusal({.E = E, .nu = 0.5}, state) ==
                  "nu is 0.5: the body keeps its volume, so that strains do not tell its mean stress; take nu below "
                  "0.5 or plane stress");
            CHECK_THROWS_AS(LinearElastic({.E = E, .nu = 0.5}, state), std::invalid_argument);
        }
        CHECK(stiffness(StressState::PlaneStress, 0.5).allFinite());
    }
}
