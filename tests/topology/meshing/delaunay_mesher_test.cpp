#include "topology/meshing/delaunay_mesher.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "tests/topology/meshing/mesh_figures.h"
#include "topology/geometry/predicates.h"

using namespace topology;
using doctest::Approx;

namespace {

CellMesh meshed(const MeshDomain& domain, const MesherOptions& options = {})
{
    return DelaunayMesher(domain, options).run();
}

} // namespace

TEST_SUITE("Delaunay meshes")
{
    TEST_CASE("A square and a square with a hole are filled, no angle below 30 degrees")
    {
        for (const double radius : {0.0, 0.2, 0.05}) {
            const MeshDomain domain = square_with_hole(10, radius);
            const CellMesh mesh = meshed(domain, {.size = 0.1});
            CAPTURE(radius);
            check_triangles(domain, mesh);
            CHECK(smallest_angle(mesh) >= 30.0);
        }
    }

    TEST_CASE("Edges are about as long as they are wanted, so that there are about as many triangles as fit")
    {
        const MeshDomain domain = square_with_hole(50, 0.0);
        const CellMesh mesh = meshed(domain, {.size = 0.02});
        const double n = domain.area() / (0.25 * std::numbers::sqrt3 * 0.02 * 0.02);
        CHECK(static_cast<double>(mesh.cells.size()) == Approx(n).epsilon(0.15));
    }

    TEST_CASE("The nodes of the domain stay where they are, the first of the mesh")
    {
        const MeshDomain domain = square_with_hole(7, 0.2);
        const CellMesh mesh = meshed(domain, {.size = 0.1});
        REQUIRE(mesh.nodes.size() > domain.nodes.size());
        CHECK(std::equal(domain.nodes.begin(), domain.nodes.end(), mesh.nodes.begin()));
    }

    TEST_CASE("Segments inside become edges, and single places nodes")
    {
        MeshDomain domain = square_with_hole(8, 0.0);
        const auto first = static_cast<CellNode>(domain.nodes.size());
        for (const FlatPoint& at : {FlatPoint{0.31, 0.43}, {0.42, 0.49}, {0.55, 0.52}, {0.8, 0.17}})
            domain.nodes.push_back(at);
        domain.segments = {{first, first + 1}, {first + 1, first + 2}};
        const CellMesh mesh = meshed(domain, {.size = 0.125});
        CHECK(area(mesh) == Approx(1.0).epsilon(1e-12));
        check_edges(domain, mesh);
        const bool is_used = std::any_of(mesh.cells.begin(), mesh.cells.end(), [&](const Cell& cell) {
            return std::ranges::count(cell.nodes(), first + 3) == 1;
        });
        CHECK(is_used);
    }

    TEST_CASE("Elements grow from small ones by no more than asked for, and are small near a place with a size")
    {
        MeshDomain domain = square_with_hole(5, 0.0);
        domain.nodes.push_back({0.5, 0.5});
        std::vector<double> sizes(domain.nodes.size());
        sizes.back() = 0.01;
        const CellMesh coarse = meshed(domain, {.size = 0.2}), fine = meshed(domain, {.size = 0.2, .sizes = sizes});
        CHECK(fine.cells.size() > 3 * coarse.cells.size());
        for (const Cell& cell : fine.cells) {
            const auto nodes = cell.nodes();
            for (std::size_t i = 0; i < 3; ++i) {
                const FlatPoint &a = fine.nodes[nodes[i]], &b = fine.nodes[nodes[(i + 1) % 3]];
                CHECK(distance(a, b) < 2.0 * (0.01 + 0.3 * distance(middle(a, b), {0.5, 0.5})) + 0.02);
            }
        }
    }

    TEST_CASE("Random stars with the sharpest corners are filled")
    {
        std::mt19937 random(11);
        for (int i = 0; i < 300; ++i) {
            const MeshDomain domain = random_star(random);
            CAPTURE(i);
            check_triangles(domain, meshed(domain, {.size = 0.2}));
        }
    }

    TEST_CASE("A long thin strip, whose parts are long beside its width, ends and is filled")
    {
        const MeshDomain domain = polygon({{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {2.0, 1e-3}, {0.9, 1e-3}, {0.0, 1e-3}});
        check_triangles(domain, meshed(domain, {.size = 0.5, .min_angle = 33.0}));
    }

    TEST_CASE("Outlines that cross or go nowhere, holes that are outside, and nodes on edges, are told")
    {
        const MeshDomain crossed = polygon({{0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}});
        CHECK_THROWS_AS(meshed(crossed), CrossingEdges);
        const MeshDomain touching = polygon({{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}});
        CHECK_THROWS_AS(meshed(touching), CrossingEdges);
        MeshDomain hole_outside = square_with_hole(4, 0.2);
        for (const CellNode node : hole_outside.loops[1]) hole_outside.nodes[node].x += 3.0;
        CHECK_THROWS_AS(meshed(hole_outside), CrossingEdges);
        MeshDomain two_edges = polygon({{0.0, 0.0}, {1.0, 0.0}});
        CHECK_THROWS_AS(meshed(two_edges), CrossingEdges);
        two_edges.loops = {{0}};
        CHECK_THROWS_AS(meshed(two_edges), CrossingEdges);
    }

    TEST_CASE("Steps come in their order: nodes, edges, what is outside, places, smoothing")
    {
        using Step = DelaunayMesher::Step;
        const MeshDomain domain = square_with_hole(4, 0.2);
        DelaunayMesher mesher(domain, {.size = 0.1, .n_sweeps = 2});
        std::vector<Step> order;
        std::size_t n_nodes = 0, n_points = 0;
        for (Step step = mesher.next(); step != Step::Done; step = mesher.next()) {
            if (order.empty() || order.back() != step) order.push_back(step);
            n_nodes += step == Step::Node ? 1U : 0U;
            n_points += step == Step::Point ? 1U : 0U;
        }
        CHECK(order == std::vector{Step::Node, Step::Edge, Step::Outside, Step::Point, Step::Smoothed});
        CHECK(n_nodes == domain.nodes.size());
        CHECK(mesher.mesh().nodes.size() == n_nodes + n_points);
    }

    TEST_CASE("Smoothing makes no angle smaller than the smallest was")
    {
        const MeshDomain domain = square_with_hole(12, 0.2);
        const double before = smallest_angle(meshed(domain, {.size = 0.08, .n_sweeps = 0}));
        const double after = smallest_angle(meshed(domain, {.size = 0.08}));
        CHECK(after >= before);
    }

    TEST_CASE("A mesh that is cancelled ends at once")
    {
        const MeshDomain domain = square_with_hole(10, 0.0);
        CHECK(DelaunayMesher(domain, {.size = 1e-3}).run([] { return true; }).cells.size() < 5000);
    }
}
