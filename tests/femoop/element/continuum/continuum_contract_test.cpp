#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

#include "femoop/element/continuum/continuum_element.h"
#include "femoop/element/continuum/continuum_model.h"
#include "femoop/material/linear_elastic.h"
#include "tests/femoop/element/continuum/plane_mesh.h"
#include "tests/femoop/element/continuum/plane_problem.h"

using namespace femoop;
using namespace femoop_test;

namespace {

constexpr double pi = std::numbers::pi;
constexpr std::array plane_states{StressState::PlaneStress, StressState::PlaneStrain, StressState::Axisymmetric};

/// A slanted element with sides of different lengths, right of the axis; those with middle nodes have bent sides.
Vector skewed(const Vector& p)
{
    return {3.1 + 1.7 * p.x() + 0.3 * p.y() + 0.2 * p.x() * p.y(),
            0.6 + 0.4 * p.x() + 1.3 * p.y() - 0.3 * p.x() * p.y()};
}
Vector bent(const Vector& p) { return skewed(p) + 0.23 * Vector(p.y() * p.y(), -p.x() * p.x()); }

Vector affine(const Vector& p) { return {3.1 + 1.7 * p.x() + 0.3 * p.y(), 0.6 + 0.4 * p.x() + 1.3 * p.y()}; }

/// A map that leaves sides straight: of a square, of which a triangle has the diagonal.
std::function<Vector(const Vector&)> straight_map(ShapeKind kind)
{
    return shape_of(kind).domain() == Domain::Triangle ? affine : skewed;
}

PlaneMesh one_element(ShapeKind kind, const std::function<Vector(const Vector&)>& map)
{
    PlaneMesh mesh = mapped(unit_square_mesh(kind, 1, 1), map);
    mesh.elements.resize(1);
    return mesh;
}

/// An element with all that it refers to.
struct Rig {
    Rig(ShapeKind kind, StressState state, const std::function<Vector(const Vector&)>& map = bent)
        : mesh(one_element(kind, map)),
          material({.E = E, .nu = nu}, state),
          formulation(shape_of(kind), standard_rule(kind, state), material, thickness),
          element(make_continuum_element(formulation, mesh.elements[0], mesh.positions))
    {}
    Eigen::MatrixXd stiffness() const
    {
        ElementMatrix K;
        element->stiffness(K);
        return K;
    }
    Eigen::VectorXd forces(const ElementLoads& loads) const
    {
        ElementVector f;
        element->equivalent_forces(loads, f);
        return f;
    }
    /// The displacements of its nodes in a field.
    Eigen::VectorXd sampled(const std::function<Vector(const Vector&)>& field) const
    {
        Eigen::VectorXd u(2 * static_cast<Eigen::Index>(mesh.elements[0].size()));
        for (int i = 0; const NodeId node : mesh.elements[0]) u.segment<2>(2 * i++) = field(mesh.positions[node.index]);
        return u;
    }

    PlaneMesh mesh;
    LinearElastic material;
    ContinuumFormulation formulation;
    std::unique_ptr<ContinuumElement> element;
};

void for_every_element(const std::function<void(ShapeKind, StressState)>& check)
{
    for (const ShapeKind kind : plane_shapes())
        for (const StressState state : plane_states) {
            CAPTURE(name(kind));
            CAPTURE(static_cast<int>(state));
            check(kind, state);
        }
}

/// Motions that strain nothing: two shifts and a turn, of a body of revolution a shift along its axis.
std::vector<std::function<Vector(const Vector&)>> rigid_motions(StressState state)
{
    const auto up = [](const Vector&) { return Vector(0.0, 1.0); };
    if (state == StressState::Axisymmetric) return {up};
    return {up, [](const Vector&) { return Vector(1.0, 0.0); }, [](const Vector& p) { return Vector(-p.y(), p.x()); }};
}

int rank(const Eigen::MatrixXd& K)
{
    const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues();
    return static_cast<int>((values.array() > 1e-10 * values.maxCoeff()).count());
}

/// Area and first moments of a straight-sided element, by its corners (Gauss and Green).
struct Polygon {
    double area = 0.0;
    Vector moment = Vector::Zero();
};
Polygon polygon(const Rig& rig)
{
    Polygon sum;
    const int n = rig.formulation.shape().n_corners();
    const auto corner = [&](int i) {
        return rig.mesh.positions[rig.mesh.elements[0][static_cast<std::size_t>(i % n)].index];
    };
    for (int i = 0; i < n; ++i) {
        const Vector a = corner(i), b = corner(i + 1);
        const double cross = a.x() * b.y() - b.x() * a.y();
        sum.area += cross / 2.0;
        sum.moment += cross / 6.0 * (a + b);
    }
    return sum;
}

} // namespace

TEST_SUITE("continuum element contract")
{
    TEST_CASE("Every element's stiffness is symmetric")
    {
        for_every_element([](ShapeKind kind, StressState state) {
            const Eigen::MatrixXd K = Rig(kind, state).stiffness();
            CHECK((K - K.transpose()).norm() <= 1e-13 * K.norm());
        });
    }

    TEST_CASE("Its rank is the degrees of freedom less the rigid motions: no motion is left without stiffness")
    {
        for_every_element([](ShapeKind kind, StressState state) {
            const Eigen::MatrixXd K = Rig(kind, state).stiffness();
            CHECK(rank(K) == K.rows() - static_cast<int>(rigid_motions(state).size()));
            CHECK(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(K).eigenvalues().minCoeff() >= -1e-12 * K.norm());
        });
    }

    TEST_CASE("A rigid motion strains nothing")
    {
        for_every_element([](ShapeKind kind, StressState state) {
            const Rig rig(kind, state);
            const Eigen::MatrixXd K = rig.stiffness(), A = rig.element->strains();
            for (const auto& motion : rigid_motions(state)) {
                const Eigen::VectorXd u = rig.sampled(motion);
                CHECK((K * u).norm() <= 1e-13 * K.norm() * u.norm());
                CHECK((A * u).norm() <= 1e-13 * A.norm() * u.norm());
            }
        });
    }

    TEST_CASE("What strains nothing at the integration points is rigid")
    {
        for_every_element([](ShapeKind kind, StressState state) {
            const Eigen::MatrixXd A = Rig(kind, state).element->strains();
            CHECK(rank(A.transpose() * A) == A.cols() - static_cast<int>(rigid_motions(state).size()));
        });
    }

    TEST_CASE("A turned element has the same energy")
    {
        const Eigen::Matrix2d R = Eigen::Rotation2Dd(0.77).toRotationMatrix();
        for_every_element([&](ShapeKind kind, StressState state) {
            if (state == StressState::Axisymmetric) return;
            const Rig before(kind, state), after(kind, state, [&](const Vector&p) { return Vector(R * bent(p)); });
            const Eigen::VectorXd u = Eigen::VectorXd::LinSpaced(before.stiffness().rows(), -0.3, 0.9);
            Eigen::VectorXd turned = u;
            for (Eigen::Index i = 0; i < u.size(); i += 2) turned.segment<2>(i) = R * u.segment<2>(i);
            CHECK(turned.dot(after.stiffness() * turned) ==
                  doctest::Approx(u.dot(before.stiffness() * u)).epsilon(1e-12));
        });
    }

    TEST_CASE("A linear field has its strains, and their stresses, at every place of the element")
    {
        const double a = 3e-4, b = -5e-4, c = 2e-4, d = 7e-4; // u = a x + c y, v = d x + b y
        for_every_element([&](ShapeKind kind, StressState state) {
            const Rig rig(kind, state);
            const bool is_axisymmetric = state == StressState::Axisymmetric;
            const double uy = is_axisymmetric ? 0.0 : c;
            const ElementVector u = rig.sampled(
                [&](const Vector& p) { return Vector(a * p.x() + uy * p.y(), d * p.x() + b * p.y()); });
            Eigen::VectorXd expected(4);
            expected << a, b, is_axisymmetric ? a : 0.0, uy + d;
            if (state == StressState::PlaneStress) expected = Eigen::Vector3d(a, b, uy + d);
            for (const NaturalPoint p : {NaturalPoint{0.2, 0.3}, NaturalPoint{0.7, 0.1}}) {
                CHECK((rig.element->strain(u, p) - expected).norm() <= 1e-15);
                const StressVector stress = rig.material.stress({.strain = expected});
                CHECK((rig.element->stress(u, p) - stress).norm() <= 1e-12 * stress.norm());
            }
        });
    }

    TEST_CASE("A body force works on every rigid motion as its resultant does")
    {
        const Vector b(-3.0, 7.0);
        for_every_element([&](ShapeKind kind, StressState state) {
            const Rig rig(kind, state, straight_map(kind));
            const std::vector<BodyLoad> loads{{[&](const Vector&) { return b; }}};
            const Eigen::VectorXd f = rig.forces({.body_loads = loads});
            const Polygon whole = polygon(rig);
            const double volume = state == StressState::Axisymmetric ? 2.0 * pi * whole.moment.x() // Pappus
                                                                     : thickness * whole.area;
            CHECK(f.dot(rig.sampled([](const Vector&) { return Vector(0.0, 1.0); })) ==
                  doctest::Approx(b.y() * volume));
            CHECK(f.dot(rig.sampled([](const Vector&) { return Vector(1.0, 0.0); })) ==
                  doctest::Approx(b.x() * volume));
            if (state == StressState::Axisymmetric) return;
            CHECK(f.dot(rig.sampled([](const Vector& p) { return Vector(-p.y(), p.x()); })) ==
                  doctest::Approx(thickness * (whole.moment.x() * b.y() - whole.moment.y() * b.x())));
        });
    }

    TEST_CASE("A traction that varies along a straight edge keeps its resultant and its moment")
    {
        const Vector t0(5.0, -2.0), t1(1.0, 11.0); // at the ends
        for_every_element([&](ShapeKind kind, StressState state) {
            const Rig rig(kind, state, straight_map(kind));
            for (int e = 0; e < rig.formulation.shape().n_corners(); ++e) {
                const Shape::Edge edge = rig.formulation.shape().edges()[static_cast<std::size_t>(e)];
                const Vector a = rig.mesh.positions[rig.mesh.elements[0][static_cast<std::size_t>(edge[0])].index];
                const Vector d = rig.mesh.positions[rig.mesh.elements[0][static_cast<std::size_t>(edge[1])].index] - a;
                const std::vector<EdgeLoad> loads{{e, [&](const EdgePoint& p) {
                                                       const double s = (p.at - a).norm() / d.norm();
                                                       return Vector((1.0 - s) * t0 + s * t1);
                                                   }}};
                const Eigen::VectorXd f = rig.forces({.edge_loads = loads});
                Vector sum = Vector::Zero();
                for (Eigen::Index i = 0; i < f.size(); i += 2) sum += f.segment<2>(i);
                // Integrals over s from 0 to 1 of t and s t:
                const Vector of_t = 0.5 * (t0 + t1), of_st = t0 / 6.0 + t1 / 3.0;
                if (state == StressState::Axisymmetric) {
                    const Vector expected = 2.0 * pi * d.norm() * (a.x() * of_t + d.x() * of_st);
                    CHECK((sum - expected).norm() <= 1e-13 * expected.norm());
                    continue;
                }
                CHECK((sum - thickness * d.norm() * of_t).norm() <= 1e-13 * sum.norm());
                const auto cross = [](const Vector& p, const Vector& q) { return p.x() * q.y() - p.y() * q.x(); };
                CHECK(f.dot(rig.sampled([](const Vector& p) { return Vector(-p.y(), p.x()); })) ==
                      doctest::Approx(thickness * d.norm() * (cross(a, of_t) + cross(d, of_st))).epsilon(1e-12));
            }
        });
    }

    TEST_CASE("Pressure all round an element, its sides bent or not, has no resultant and turns nothing")
    {
        for_every_element([](ShapeKind kind, StressState state) {
            if (state == StressState::Axisymmetric) return;
            const Rig rig(kind, state);
            std::vector<EdgeLoad> loads;
            for (int e = 0; e < rig.formulation.shape().n_corners(); ++e)
                loads.push_back({e, [](const EdgePoint& p) { return Vector(-13.0 * p.outward); }});
            const Eigen::VectorXd f = rig.forces({.edge_loads = loads});
            CHECK(f.norm() > 1.0);
            for (const auto& motion : rigid_motions(state))
                CHECK(std::abs(f.dot(rig.sampled(motion))) <= 1e-12 * f.norm());
        });
    }

    TEST_CASE("On the axis of a body of revolution the hoop strain is the radial one")
    {
        for (const ShapeKind kind : plane_shapes()) {
            CAPTURE(name(kind));
            const Rig rig(kind, StressState::Axisymmetric,
                          [](const Vector& p) { return Vector(1.3 * p.x(), 0.7 * p.y()); });
            const ElementVector u = rig.sampled([](const Vector& p) { return Vector(3e-4 * p.x(), 0.0); });
            const StrainVector strain = rig.element->strain(u, shape_of(kind).nodes()[0]);
            CHECK(strain[0] == doctest::Approx(3e-4));
            CHECK(strain[2] == doctest::Approx(3e-4));
        }
    }
}
