#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <numbers>

#include "femoop/material/linear_elastic.h"
#include "tests/femoop/element/continuum/plane_mesh.h"
#include "tests/femoop/element/continuum/plane_problem.h"

using namespace femoop;
using namespace femoop_test;

namespace {

using Field = std::function<StressVector(const Vector&)>;

/// Halving the elements of a smooth problem divides the error in energy by 2^p, p the shape's degree
/// [Hughes2000].
void check_rate(ShapeKind kind, double coarse, double fine)
{
    CAPTURE(coarse);
    CAPTURE(fine);
    CHECK(std::log2(coarse / fine) > shape_of(kind).degree() - 0.15);
    CHECK(fine < 0.05);
}

/// Lame's thick cylinder under inner pressure, its ends held:
///      sr, st = p a^2 / (b^2 - a^2) (1 -+ b^2 / r^2)     u = p a^2 r / (b^2 - a^2) (1 - 2 nu + b^2 / r^2) (1 + nu) / E
/// Source  [TimoshenkoGoodier1970, art. 28]
struct ThickCylinder {
    static constexpr double a = 2.0, b = 5.0, p = 13.0, height = 1.5;
    static constexpr double c = p * a * a / (b * b - a * a);

    static StressVector stress(const Vector& at)
    {
        const double q = b * b / (at.x() * at.x());
        return Eigen::Vector4d(c * (1.0 - q), 2.0 * nu * c, c * (1.0 + q), 0.0);
    }
    static double displacement(double r) { return c * r * (1.0 - 2.0 * nu + b * b / (r * r)) * (1.0 + nu) / E; }
};

struct Outcome {
    double energy_error, displacement_error; ///< of the exact ones
};

Outcome solve_thick_cylinder(ShapeKind kind, int n)
{
    using C = ThickCylinder;
    const PlaneMesh mesh = mapped(unit_square_mesh(kind, n, n / 2), [](const Vector& p) {
        return Vector(C::a + (C::b - C::a) * p.x(), C::height * p.y());
    });
    const LinearElastic material({.E = E, .nu = nu}, StressState::Axisymmetric);
    const ContinuumFormulation formulation(shape_of(kind), standard_rule(kind, material.state()), material);
    PlaneProblem problem(mesh, formulation);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        if (const double y = mesh.positions[i].y(); y == 0.0 || y == C::height)
            problem.prescribe(NodeId(i), Dof::uy, 0.0);
    problem.pull([](const EdgePoint& edge) { return Vector(-C::p * edge.outward); },
                 [](const Vector& middle) { return middle.x() == C::a; });
    problem.solve();
    double worst = 0.0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        worst = std::max(worst, std::abs(problem.displacement(NodeId(i)).x() - C::displacement(mesh.positions[i].x())));
    return {.energy_error = energy_error(problem, C::stress), .displacement_error = worst / C::displacement(C::a)};
}

/// Kirsch's sheet with a round hole, pulled along x by 1 far away.  Source  [TimoshenkoGoodier1970, art. 35]
struct Kirsch {
    static constexpr double a = 1.0, far = 4.0;

    static StressVector stress(const Vector& at)
    {
        const double r = at.norm(), q = a * a / (r * r), angle = std::atan2(at.y(), at.x());
        const double c2 = std::cos(2.0 * angle), c4 = std::cos(4.0 * angle);
        const double s2 = std::sin(2.0 * angle), s4 = std::sin(4.0 * angle);
        return Eigen::Vector3d(1.0 - q * (1.5 * c2 + c4) + 1.5 * q * q * c4, -q * (0.5 * c2 - c4) - 1.5 * q * q * c4,
                               -q * (0.5 * s2 + s4) + 1.5 * q * q * s4);
    }
};

/// A quarter of the sheet out to a circle, on which Kirsch's stresses pull; cells grow outwards.
PlaneMesh kirsch_mesh(ShapeKind kind, int n)
{
    return mapped(unit_square_mesh(kind, n, n), [](const Vector& p) {
        const double r = Kirsch::a * std::pow(Kirsch::far / Kirsch::a, p.x());
        const double angle = 0.5 * std::numbers::pi * p.y();
        return Vector(r * std::cos(angle), p.y() == 1.0 ? r : r * std::sin(angle));
    });
}

struct KirschOutcome {
    double energy_error, peak; ///< sx at the hole's top
};

KirschOutcome solve_kirsch(ShapeKind kind, int n)
{
    const PlaneMesh mesh = kirsch_mesh(kind, n);
    const LinearElastic material({.E = E, .nu = nu}, StressState::PlaneStress);
    const ContinuumFormulation formulation(shape_of(kind), standard_rule(kind, material.state()), material, thickness);
    PlaneProblem problem(mesh, formulation);
    const double on_axis = 1e-12 * Kirsch::far;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (mesh.positions[i].x() < on_axis) problem.prescribe(NodeId(i), Dof::ux, 0.0);
        if (mesh.positions[i].y() < on_axis) problem.prescribe(NodeId(i), Dof::uy, 0.0);
    }
    problem.pull([](const EdgePoint& edge) { return traction(Kirsch::stress(edge.at), edge); },
                 [](const Vector& middle) { return middle.norm() > 0.9 * Kirsch::far; });
    problem.solve();
    KirschOutcome outcome{.energy_error = energy_error(problem, Kirsch::stress), .peak = 0.0};
    for (std::size_t e = 0; e < problem.n_elements(); ++e)
        for (const NaturalPoint p : formulation.shape().nodes())
            if ((problem.element(e).place(p) - Vector(0.0, Kirsch::a)).norm() < on_axis)
                outcome.peak = problem.field(e).stress(p)[0];
    return outcome;
}

/// A cantilever from x = 0 to L, -c <= y <= c, sheared by P down over its end x = L as a parabola.
///      sx = P (L - x) y / I     txy = -P (c^2 - y^2) / 2 I        Source  [TimoshenkoGoodier1970, art. 21]
struct Cantilever {
    static constexpr double L = 8.0, c = 1.0, P = 3.0;
    static constexpr double I = 2.0 / 3.0 * thickness * c * c * c;

    static StressVector stress(const Vector& at)
    {
        const double y = at.y();
        return Eigen::Vector3d(P * (L - at.x()) * y / I, 0.0, -P * (c * c - y * y) / (2.0 * I));
    }
};

double solve_cantilever(ShapeKind kind, int n)
{
    using B = Cantilever;
    const PlaneMesh mesh = mapped(unit_square_mesh(kind, 4 * n, n),
                                  [](const Vector& p) { return Vector(B::L * p.x(), B::c * (2.0 * p.y() - 1.0)); });
    const LinearElastic material({.E = E, .nu = nu}, StressState::PlaneStress);
    const ContinuumFormulation formulation(shape_of(kind), standard_rule(kind, material.state()), material, thickness);
    PlaneProblem problem(mesh, formulation);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        if (mesh.positions[i] == Vector(0.0, -B::c)) {
            problem.prescribe(NodeId(i), Dof::ux, 0.0);
            problem.prescribe(NodeId(i), Dof::uy, 0.0);
        } else if (mesh.positions[i] == Vector(0.0, B::c)) problem.prescribe(NodeId(i), Dof::ux, 0.0);
    problem.pull([](const EdgePoint& edge) { return traction(B::stress(edge.at), edge); }, everywhere);
    problem.solve();
    return energy_error(problem, B::stress);
}

} // namespace

TEST_SUITE("convergence")
{
    TEST_CASE("A thick cylinder's error in energy falls with the power of h that is the shape's degree")
    {
        for (const ShapeKind kind : plane_shapes()) {
            CAPTURE(name(kind));
            const Outcome coarse = solve_thick_cylinder(kind, 8), fine = solve_thick_cylinder(kind, 16);
            check_rate(kind, coarse.energy_error, fine.energy_error);
            // Displacements gain one power more.
            CHECK(std::log2(coarse.displacement_error / fine.displacement_error) > shape_of(kind).degree() + 0.5);
        }
    }

    TEST_CASE("The sheet with a round hole converges to Kirsch's stresses, three times the pull beside the hole")
    {
        for (const ShapeKind kind : plane_shapes()) {
            CAPTURE(name(kind));
            const KirschOutcome coarse = solve_kirsch(kind, 8), fine = solve_kirsch(kind, 16);
            check_rate(kind, coarse.energy_error, fine.energy_error);
            CHECK(std::abs(fine.peak / 3.0 - 1.0) < (shape_of(kind).degree() == 1 ? 0.2 : 0.01));
        }
    }

    TEST_CASE("A cantilever with a parabola of shear at its end converges to the theory of elasticity")
    {
        for (const ShapeKind kind : plane_shapes()) {
            CAPTURE(name(kind));
            const double coarse = solve_cantilever(kind, 8), fine = solve_cantilever(kind, 16);
            CHECK(std::log2(coarse / fine) > shape_of(kind).degree() - 0.15);
        }
    }
}
