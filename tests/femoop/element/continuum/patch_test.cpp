#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <functional>

#include "femoop/material/linear_elastic.h"
#include "tests/femoop/element/continuum/plane_mesh.h"
#include "tests/femoop/element/continuum/plane_problem.h"

using namespace femoop;
using namespace femoop_test;

namespace {

constexpr double tolerance = 1e-9;

/// A block right of the axis whose inner nodes stand as they like.
PlaneMesh patch(ShapeKind kind, Sides sides)
{
    return mapped(shaken(unit_square_mesh(kind, 3, 3), 0.09, sides),
                  [](const Vector& p) { return Vector(2.1 + 2.3 * p.x(), -0.7 + 1.9 * p.y()); });
}

/// A linear field with the same strain everywhere. In a body of revolution ur = a r is the only one of its kind.
struct LinearField {
    explicit LinearField(StressState state) : is_axisymmetric(state == StressState::Axisymmetric) {}
    Vector at(const Vector& p) const
    {
        if (is_axisymmetric) return {a * p.x(), b * p.y() + 4e-4};
        return {a * p.x() + c * p.y() - 6e-4, d * p.x() + b * p.y() + 4e-4};
    }
    StrainVector strain(StressState state) const
    {
        if (is_axisymmetric) return Eigen::Vector4d(a, b, a, 0.0);
        if (state == StressState::PlaneStrain) return Eigen::Vector4d(a, b, 0.0, c + d);
        return Eigen::Vector3d(a, b, c + d);
    }
    static constexpr double a = 3e-4, b = -5e-4, c = 2e-4, d = 7e-4;
    bool is_axisymmetric;
};

void for_every_patch(const std::function<void(ShapeKind, StressState, const PlaneMesh&)>& check)
{
    for (const ShapeKind kind : plane_shapes())
        for (const StressState state : {StressState::PlaneStress, StressState::PlaneStrain, StressState::Axisymmetric})
            for (const Sides sides : {Sides::Straight, Sides::Curved}) {
                if (sides == Sides::Curved && shape_of(kind).degree() == 1) continue;
                CAPTURE(name(kind));
                CAPTURE(static_cast<int>(state));
                CAPTURE(static_cast<int>(sides));
                check(kind, state, patch(kind, sides));
            }
}

void check_field(const PlaneProblem& problem, const PlaneMesh& mesh, const LinearField& field,
                 const StressVector& stress)
{
    double worst = 0.0, largest = 0.0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const Vector exact = field.at(mesh.positions[i]);
        worst = std::max(worst, (problem.displacement(NodeId(i)) - exact).norm());
        largest = std::max(largest, exact.norm());
    }
    CHECK(worst <= tolerance * largest);
    double stress_error = 0.0;
    problem.at_integration_points([&](std::size_t e, const IntegrationPoint& point) {
        const StressVector found = problem.field(e).stress(point.at);
        stress_error = std::max(stress_error, (found - stress).norm());
    });
    CHECK(stress_error <= tolerance * stress.norm());
    double inside_error = 0.0;
    problem.at_integration_points([&](std::size_t e, const IntegrationPoint& point) {
        const ElementField inside = problem.field(e);
        inside_error = std::max(inside_error,
                                (inside.displacement(point.at) - field.at(inside.place(point.at))).norm());
    });
    CHECK(inside_error <= tolerance * largest);
}

} // namespace

// Source  [ZienkiewiczTaylor2000, ch. 10]
TEST_SUITE("patch test")
{
    TEST_CASE("With a linear field on its boundary, a distorted patch has that field inside, and one stress")
    {
        for_every_patch([](ShapeKind kind, StressState state, const PlaneMesh& mesh) {
            const LinearElastic material({.E = E, .nu = nu}, state);
            const ContinuumFormulation formulation(shape_of(kind), standard_rule(kind, state), material, thickness);
            const LinearField field(state);
            PlaneProblem problem(mesh, formulation);
            const std::vector<bool> is_held = is_on_boundary(mesh);
            std::size_t n_inside = 0;
            for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
                const Vector u = field.at(mesh.positions[i]);
                n_inside += is_held[i] ? 0 : 1;
                if (!is_held[i]) continue;
                problem.prescribe(NodeId(i), Dof::ux, u.x());
                problem.prescribe(NodeId(i), Dof::uy, u.y());
            }
            REQUIRE(n_inside >= 4);
            problem.solve();
            check_field(problem, mesh, field, material.stress({.strain = field.strain(state)}));
        });
    }

    TEST_CASE("Tractions of one stress on its boundary give a distorted patch that stress and its linear field")
    {
        for_every_patch([](ShapeKind kind, StressState state, const PlaneMesh& mesh) {
            const LinearElastic material({.E = E, .nu = nu}, state);
            const ContinuumFormulation formulation(shape_of(kind), standard_rule(kind, state), material, thickness);
            const LinearField field(state);
            const StressVector stress = material.stress({.strain = field.strain(state)});
            PlaneProblem problem(mesh, formulation);
            problem.pull([&](const EdgePoint& edge) { return traction(stress, edge); }, everywhere);
            // Just held: both directions of the first node, and what keeps the last of its row from turning.
            const Vector first = field.at(mesh.positions.front());
            problem.prescribe(NodeId(0), Dof::uy, first.y());
            if (state != StressState::Axisymmetric) {
                std::size_t other = 0;
                for (std::size_t i = 0; i < mesh.positions.size(); ++i)
                    if (mesh.positions[i].y() == mesh.positions[0].y()) other = i;
                problem.prescribe(NodeId(0), Dof::ux, first.x());
                problem.prescribe(NodeId(other), Dof::uy, field.at(mesh.positions[other]).y());
            }
            problem.solve();
            check_field(problem, mesh, field, stress);
        });
    }

    TEST_CASE("A patch of quadratic elements with straight sides has a quadratic field, which body forces balance")
    {
        // u = k x^2, v = k x y: strains 2 k x, k x, gxy = k y; of plane stress with c = E / (1 - nu^2):
        // sx = c k x (2 + nu), txy = G k y, so that bx = -(dsx/dx + dtxy/dy); sy and txy vary with x and y alone: by =
        // 0.
        const double k = 3e-4, c = E / (1.0 - nu * nu), G = E / (2.0 * (1.0 + nu));
        const auto exact = [&](const Vector& p) { return Vector(k * p.x() * p.x(), k * p.x() * p.y()); };
        for (const ShapeKind kind : plane_shapes()) {
            if (shape_of(kind).degree() < 2) continue;
            CAPTURE(name(kind));
            const LinearElastic material({.E = E, .nu = nu}, StressState::PlaneStress);
            const ContinuumFormulation formulation(shape_of(kind), standard_rule(kind, StressState::PlaneStress),
                                                   material, thickness);
            // Q8 lacks x^2 y^2, which a quadratic field has in a distorted quadrilateral: parallelograms for it.
            const PlaneMesh slanted = mapped(unit_square_mesh(kind, 3, 3), [](const Vector& p) {
                return Vector(2.1 + 2.3 * p.x() + 0.4 * p.y(), -0.7 + 0.3 * p.x() + 1.9 * p.y());
            });
            const PlaneMesh mesh = kind == ShapeKind::Q8 ? slanted : patch(kind, Sides::Straight);
            PlaneProblem problem(mesh, formulation);
            const std::vector<bool> is_held = is_on_boundary(mesh);
            for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
                if (!is_held[i]) continue;
                problem.prescribe(NodeId(i), Dof::ux, exact(mesh.positions[i]).x());
                problem.prescribe(NodeId(i), Dof::uy, exact(mesh.positions[i]).y());
            }
            problem.pull_inside([&](const Vector&) { return Vector(-(c * k * (2.0 + nu) + G * k), 0.0); });
            problem.solve();
            for (std::size_t i = 0; i < mesh.positions.size(); ++i)
                CHECK((problem.displacement(NodeId(i)) - exact(mesh.positions[i])).norm() <= tolerance * k * 20.0);
        }
    }
}
