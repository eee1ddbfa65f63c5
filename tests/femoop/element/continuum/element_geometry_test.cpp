#include "femoop/element/continuum/element_geometry.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

#include "femoop/element/continuum/continuum_element.h"
#include "femoop/element/continuum/continuum_formulation.h"
#include "femoop/material/linear_elastic.h"

using namespace femoop;

namespace {

NodePositions nodes_at(std::initializer_list<Eigen::Vector2d> places)
{
    NodePositions X(static_cast<Eigen::Index>(places.size()), 2);
    for (Eigen::Index i = 0; const Eigen::Vector2d& place : places) X.row(i++) = place;
    return X;
}

std::string refusal(ShapeKind kind, const NodePositions& X)
{
    const auto fault = why_not_element(shape_of(kind), standard_rule(kind, StressState::PlaneStress), X);
    return fault ? message(*fault) : "";
}

/// A Q8 over 0 <= x <= 4, 0 <= y <= 2 with the middle node of its lower side at x.
NodePositions q8_with_middle_at(double x)
{
    return nodes_at({{0, 0}, {4, 0}, {4, 2}, {0, 2}, {x, 0}, {4, 1}, {2, 2}, {0, 1}});
}

} // namespace

TEST_SUITE("element geometry")
{
    TEST_CASE("Nodes that run clockwise are refused")
    {
        CHECK(refusal(ShapeKind::T3, nodes_at({{0, 0}, {0, 2}, {3, 0}})) ==
              "the nodes of this T3 run clockwise; list them counter-clockwise");
        CHECK(refusal(ShapeKind::Q4, nodes_at({{0, 0}, {0, 2}, {3, 2}, {3, 0}})) ==
              "the nodes of this Q4 run clockwise; list them counter-clockwise");
    }

    TEST_CASE("A re-entrant corner is refused and named")
    {
        CHECK(
            refusal(ShapeKind::Q4, nodes_at({{0, 0}, {4, 0}, {1, 1}, {0, 4}})) ==
            "this Q4 is too distorted: its Jacobian is -2 at node 3 and must be positive; keep its corners convex and "
            "middle nodes near mid-side");
    }

    TEST_CASE("Sides that cross are refused")
    {
        CHECK(refusal(ShapeKind::Q4, nodes_at({{0, 0}, {3, 0}, {0, 2}, {3, 2}})) != "");
    }

    TEST_CASE("A middle node may stand anywhere between the quarters of its side, not on them")
    {
        CHECK(refusal(ShapeKind::Q8, q8_with_middle_at(2.0)) == "");
        CHECK(refusal(ShapeKind::Q8, q8_with_middle_at(1.01)) == "");
        CHECK(refusal(ShapeKind::Q8, q8_with_middle_at(2.99)) == "");
        CHECK(refusal(ShapeKind::Q8, q8_with_middle_at(1.0)) != "");
        CHECK(refusal(ShapeKind::Q8, q8_with_middle_at(3.0)) != "");
        CHECK(refusal(ShapeKind::Q8, q8_with_middle_at(0.9)).find("at node 1 ") != std::string::npos);
    }

    TEST_CASE("Nodes in one line, or in one place, are refused")
    {
        CHECK(refusal(ShapeKind::T3, nodes_at({{0, 0}, {1, 2}, {3, 6}})) ==
              "the nodes of this T3 lie in one line, so that it has no area; move a node out of it");
        CHECK(refusal(ShapeKind::T3, nodes_at({{0.1, 0.3}, {0.2, 0.6}, {0.3, 0.9}})) != ""); // but for rounding
        CHECK(refusal(ShapeKind::T3, nodes_at({{1, 1}, {1, 1}, {1, 1}})) != "");
        CHECK(refusal(ShapeKind::Q4, nodes_at({{0, 0}, {1, 0}, {1, 0}, {0, 0}})) != "");
    }

    TEST_CASE("Places that are no numbers are refused")
    {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        CHECK(refusal(ShapeKind::T3, nodes_at({{0, 0}, {nan, 0}, {0, 1}})) != "");
        CHECK(refusal(ShapeKind::T3, nodes_at({{0, 0}, {1, 0}, {0, nan}})) != "");
    }

    TEST_CASE("Another number of nodes than the shape's is refused")
    {
        CHECK(refusal(ShapeKind::T6, nodes_at({{0, 0}, {1, 0}, {0, 1}})) == "a T6 has 6 nodes, not 3");
    }

    TEST_CASE("Small elements far from the origin, and long thin ones, are no worse than others")
    {
        CHECK(refusal(ShapeKind::T3, nodes_at({{1e6, 1e6}, {1e6 + 1e-3, 1e6}, {1e6, 1e6 + 1e-3}})) == "");
        CHECK(refusal(ShapeKind::Q4, nodes_at({{0, 0}, {1e6, 0}, {1e6, 1e-6}, {0, 1e-6}})) == "");
    }

    TEST_CASE("A body of revolution has no node left of its axis")
    {
        const Shape& shape = shape_of(ShapeKind::T3);
        CHECK_FALSE(why_not_axisymmetric(shape, nodes_at({{0, 0}, {1, 0}, {0, 1}})));
        const auto fault = why_not_axisymmetric(shape, nodes_at({{0, 0}, {1, 0}, {-0.5, 1}}));
        REQUIRE(fault);
        CHECK(message(*fault) == "node 3 of this T3 has the radius -0.5; a body of revolution lies at x >= 0");
    }

    TEST_CASE("An element that cannot be is not made")
    {
        const LinearElastic material({.E = 3.0, .nu = 0.2}, StressState::PlaneStress);
        const Shape& shape = shape_of(ShapeKind::T3);
        const ContinuumFormulation formulation(shape, symmetric_triangle(1), material, 2.0);
        const std::vector<Eigen::Vector2d> positions{{0, 0}, {0, 1}, {1, 0}};
        const std::vector<NodeId> clockwise{NodeId(0), NodeId(1), NodeId(2)}, two{NodeId(0), NodeId(1)};
        CHECK_THROWS_WITH(make_continuum_element(formulation, clockwise, positions),
                          "the nodes of this T3 run clockwise; list them counter-clockwise");
        CHECK_THROWS_WITH(make_continuum_element(formulation, two, positions), "a T3 has 3 nodes, not 2");
    }

    TEST_CASE("Factors that do not fit together are refused")
    {
        const LinearElastic material({.E = 3.0, .nu = 0.2}, StressState::PlaneStress);
        const LinearElastic solid({.E = 3.0, .nu = 0.2}, StressState::Solid);
        const Shape& shape = shape_of(ShapeKind::T3);
        CHECK_THROWS_AS(ContinuumFormulation(shape, gauss_quadrilateral(2), material), std::invalid_argument);
        CHECK_THROWS_AS(ContinuumFormulation(shape, symmetric_triangle(1), material, 0.0), std::invalid_argument);
        CHECK_THROWS_AS(ContinuumFormulation(shape, symmetric_triangle(1), solid), std::invalid_argument);
        CHECK_THROWS_AS(ContinuumFormulation(shape_of(ShapeKind::Line2), gauss_line(2), material),
                        std::invalid_argument);
    }
}
