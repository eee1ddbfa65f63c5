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

/// One element from -a to a and from -b to b, bent by moments M about z on its ends x = -a and x = a.
struct BentElement {
    BentElement(ShapeKind kind, double half_length)
        : a(half_length),
          mesh(mapped(unit_square_mesh(kind, 1, 1),
                      [this](const Vector& p) { return Vector(a * (2.0 * p.x() - 1.0), b * (2.0 * p.y() - 1.0)); })),
          material({.E = E, .nu = nu}, StressState::PlaneStress),
          formulation(shape_of(kind), standard_rule(kind, StressState::PlaneStress), material, thickness),
          problem(mesh, formulation)
    {
        problem.pull([](const EdgePoint& edge) { return Vector(-M * edge.at.y() / I * edge.outward.x(), 0.0); },
                     [this](const Vector& middle) { return std::abs(middle.x()) > 0.5 * a; });
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const Vector p = mesh.positions[i];
            if (p.x() < 0.0 && p.y() < 0.0 && std::abs(p.x()) == a && std::abs(p.y()) == b) {
                problem.prescribe(NodeId(i), Dof::ux, 0.0);
                problem.prescribe(NodeId(i), Dof::uy, 0.0);
            }
            if (p.x() == a && p.y() == -b) problem.prescribe(NodeId(i), Dof::uy, 0.0);
        }
        problem.solve();
    }
    static constexpr double b = 0.7, M = 11.0;
    static constexpr double I = thickness * 8.0 * b * b * b / 12.0;
    double a;
    PlaneMesh mesh;
    LinearElastic material;
    ContinuumFormulation formulation;
    PlaneProblem problem;
};

} // namespace

TEST_SUITE("bending")
{
    TEST_CASE("One element of eight or nine nodes bends as the beam does: energy M^2 L / 2 E I, stress -M y / I")
    {
        for (const ShapeKind kind : plane_shapes()) {
            if (shape_of(kind).domain() == Domain::Triangle || shape_of(kind).degree() < 2) continue;
            CAPTURE(name(kind));
            const BentElement bent(kind, 3.1);
            const auto [b, M, I] = std::array{BentElement::b, BentElement::M, BentElement::I};
            CHECK(bent.problem.strain_energy() == doctest::Approx(M * M * 2.0 * bent.a / (2.0 * E * I)).epsilon(1e-10));
            for (const NaturalPoint p : {NaturalPoint{0.3, -0.8}, NaturalPoint{-0.9, 1.0}}) {
                const StressVector s = bent.problem.field(0).stress(p);
                CHECK((s - Eigen::Vector3d(-M * b * p.eta / I, 0.0, 0.0)).norm() <= 1e-9 * M * b / I);
            }
        }
    }

    // Its only bending mode is u = k x y, v = 0, with gxy = k x beside ex = k y. Energy over the rectangle against that
    // of the beam at the same curvature k:  1 / (1 - nu^2) + (a / b)^2 / (2 (1 + nu))  [CookMalkusPleshaWitt2002]
    TEST_CASE("One Q4 locks in shear: it is 1 / (1 - nu^2) + (a / b)^2 / 2 (1 + nu) times as stiff as the beam")
    {
        for (const double half_length : {0.7, 3.1, 17.0}) {
            CAPTURE(half_length);
            const BentElement bent(ShapeKind::Q4, half_length);
            const auto [b, M, I] = std::array{BentElement::b, BentElement::M, BentElement::I};
            const double beam = M * M * 2.0 * half_length / (2.0 * E * I);
            const double too_stiff = 1.0 / (1.0 - nu * nu) + std::pow(half_length / b, 2) / (2.0 * (1.0 + nu));
            CHECK(beam / bent.problem.strain_energy() == doctest::Approx(too_stiff).epsilon(1e-10));
        }
    }
}
