#include "femoop/shape/shape.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

using namespace femoop;

namespace {

void for_every_shape(const std::function<void(const Shape&)>& check)
{
    for (const ShapeKind kind : shape_kinds()) {
        CAPTURE(name(kind));
        check(shape_of(kind));
    }
}

/// Places all over the domain, none of them special.
std::vector<NaturalPoint> places(Domain domain)
{
    if (domain == Domain::Line) return {{.xi = -0.83}, {.xi = 0.27}, {.xi = 0.61}};
    if (domain == Domain::Triangle) return {{0.11, 0.23}, {0.67, 0.19}, {0.07, 0.83}, {0.31, 0.37}};
    return {{-0.83, 0.37}, {0.27, -0.59}, {0.61, 0.71}, {-0.13, -0.93}};
}

double monomial(NaturalPoint p, int i, int j) { return std::pow(p.xi, i) * std::pow(p.eta, j); }

/// What the shape makes at p of a monomial's values at its nodes.
double interpolated(const Shape& shape, NaturalPoint p, int i, int j)
{
    const Shape::Values N = shape.values(p);
    double sum = 0.0;
    for (int k = 0; k < shape.n_nodes(); ++k) sum += N[k] * monomial(shape.nodes()[k], i, j);
    return sum;
}

} // namespace

TEST_SUITE("shape contract")
{
    TEST_CASE("The functions of every shape add up to one, their derivatives to nothing")
    {
        for_every_shape([](const Shape& shape) {
            for (const NaturalPoint p : places(shape.domain())) {
                CHECK(shape.values(p).sum() == doctest::Approx(1.0).epsilon(1e-15));
                CHECK(shape.derivatives(p).colwise().sum().cwiseAbs().maxCoeff() <= 1e-14);
            }
        });
    }

    TEST_CASE("Each function is one at its own node and nothing at all others")
    {
        for_every_shape([](const Shape& shape) {
            const int n = shape.n_nodes();
            for (int i = 0; i < n; ++i)
                CHECK((shape.values(shape.nodes()[i]) - Eigen::VectorXd::Unit(n, i)).cwiseAbs().maxCoeff() <= 1e-15);
        });
    }

    TEST_CASE("Derivatives match finite differences")
    {
        for_every_shape([](const Shape& shape) {
            const double h = 1e-5; // central differences of quadratics and cubics: h^2 and rounding / h
            for (const auto [xi, eta] : places(shape.domain())) {
                const Shape::Derivatives d = shape.derivatives({xi, eta});
                const Eigen::VectorXd by_xi = (shape.values({xi + h, eta}) - shape.values({xi - h, eta})) / (2.0 * h);
                const Eigen::VectorXd by_eta = (shape.values({xi, eta + h}) - shape.values({xi, eta - h})) / (2.0 * h);
                CHECK((d.col(0) - by_xi).cwiseAbs().maxCoeff() <= 1e-9);
                CHECK((d.col(1) - by_eta).cwiseAbs().maxCoeff() <= 1e-9);
            }
        });
    }

    TEST_CASE("Every polynomial up to a shape's degree is reproduced, and not all of the next")
    {
        for_every_shape([](const Shape& shape) {
            double missed = 0.0;
            for (int i = 0; i <= shape.degree() + 1; ++i)
                for (int j = 0; i + j <= shape.degree() + 1; ++j) {
                    if (shape.domain() == Domain::Line && j > 0) continue;
                    for (const NaturalPoint p : places(shape.domain())) {
                        const double error = std::abs(interpolated(shape, p, i, j) - monomial(p, i, j));
                        if (i + j <= shape.degree()) CHECK(error <= 1e-15);
                        else missed = std::max(missed, error);
                    }
                }
            CHECK(missed > 1e-3);
        });
    }

    TEST_CASE("Along an edge only its own nodes count, with the functions of the edge's shape")
    {
        for_every_shape([](const Shape& shape) {
            for (const Shape::Edge edge : shape.edges()) {
                const Shape& line = shape_of(*shape.edge_kind());
                REQUIRE(edge.size() == static_cast<std::size_t>(line.n_nodes()));
                const auto a = shape.nodes()[edge[0]], b = shape.nodes()[edge[1]];
                for (const double t : {-0.83, 0.27, 1.0}) {
                    const NaturalPoint p{.xi = 0.5 * ((1.0 - t) * a.xi + (1.0 + t) * b.xi),
                                         .eta = 0.5 * ((1.0 - t) * a.eta + (1.0 + t) * b.eta)};
                    Eigen::VectorXd expected = Eigen::VectorXd::Zero(shape.n_nodes());
                    for (std::size_t i = 0; i < edge.size(); ++i) expected[edge[i]] = line.values({.xi = t})[i];
                    CHECK((shape.values(p) - expected).cwiseAbs().maxCoeff() <= 1e-15);
                }
            }
        });
    }

    TEST_CASE("Edges go round counter-clockwise, from corner to corner, and use every node but a centre")
    {
        for_every_shape([](const Shape& shape) {
            if (shape.domain() == Domain::Line) return;
            double doubled_area = 0.0;
            std::vector<int> times(static_cast<std::size_t>(shape.n_nodes()), 0);
            for (std::size_t e = 0; e < shape.edges().size(); ++e) {
                const Shape::Edge edge = shape.edges()[e];
                CHECK(edge[0] == static_cast<int>(e));
                CHECK(edge[1] == shape.edges()[(e + 1) % shape.edges().size()][0]);
                const auto a = shape.nodes()[edge[0]], b = shape.nodes()[edge[1]];
                doubled_area += a.xi * b.eta - b.xi * a.eta;
                for (const int node : edge) ++times[static_cast<std::size_t>(node)];
            }
            CHECK(0.5 * doubled_area == doctest::Approx(measure(shape.domain())));
            for (int i = 0; i < shape.n_nodes(); ++i) {
                const NaturalPoint c = centroid(shape.domain()), node = shape.nodes()[i];
                const int expected = node.xi == c.xi && node.eta == c.eta ? 0 : (i < shape.n_corners() ? 2 : 1);
                CHECK(times[static_cast<std::size_t>(i)] == expected);
            }
        });
    }

    TEST_CASE("The corners' mean is the domain's centroid")
    {
        for_every_shape([](const Shape& shape) {
            double xi = 0.0, eta = 0.0;
            for (int i = 0; i < shape.n_corners(); ++i) {
                xi += shape.nodes()[i].xi / shape.n_corners();
                eta += shape.nodes()[i].eta / shape.n_corners();
            }
            CHECK(xi == doctest::Approx(centroid(shape.domain()).xi));
            CHECK(eta == doctest::Approx(centroid(shape.domain()).eta));
        });
    }

    TEST_CASE("A shape knows the kind that it was asked for by")
    {
        for (const ShapeKind kind : shape_kinds()) CHECK(shape_of(kind).kind() == kind);
    }
}
