#include "topology/meshing/quadtree_mesher.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "tests/topology/meshing/mesh_figures.h"

using namespace topology;
using doctest::Approx;

namespace {

CellMesh tree_mesh(const MeshDomain& domain, const MesherOptions& options = {})
{
    return QuadtreeMesher(domain, options).run();
}

} // namespace

TEST_SUITE("meshes by a quadtree")
{
    TEST_CASE("By a quadtree a square and a square with a hole are filled, no angle below 25 degrees")
    {
        for (const double radius : {0.0, 0.2, 0.05}) {
            const MeshDomain domain = square_with_hole(10, radius);
            const CellMesh mesh = tree_mesh(domain, {.size = 0.1});
            CAPTURE(radius);
            check_triangles(domain, mesh);
            CHECK(smallest_angle(mesh) >= 25.0);
        }
    }

    TEST_CASE("A place is inside a ring with teeth where its distance from the middle says so")
    {
        MeshDomain ring;
        const auto add_loop = [&](int n, double radius, bool is_clockwise) {
            std::vector<CellNode>& loop = ring.loops.emplace_back();
            for (int i = 0; i < n; ++i) {
                const double angle = 2.0 * std::numbers::pi * (is_clockwise ? -i : i) / n,
                             r = radius * (i % 2 == 0 ? 1.0 : 1.05);
                loop.push_back(static_cast<CellNode>(ring.nodes.size()));
                ring.nodes.push_back({3.0 + r * std::cos(angle), -7.0 + r * std::sin(angle)});
            }
        };
        add_loop(3000, 2.0, false);
        add_loop(700, 0.5, true);
        const InsideTest test(ring);
        std::mt19937 random(11);
        std::uniform_real_distribution<double> within(-2.5, 2.5);
        int n_inside = 0;
        for (int i = 0; i < 5000; ++i) {
            const FlatPoint at{3.0 + within(random), -7.0 + within(random)};
            const double r = std::hypot(at.x - 3.0, at.y + 7.0);
            const bool is_inside = test.has_inside(at);
            n_inside += is_inside ? 1 : 0;
            if (r < 0.49 || r > 2.11) CHECK(!is_inside);
            if (r > 0.53 && r < 1.99) CHECK(is_inside);
        }
        CHECK(n_inside > 1000);
    }

    TEST_CASE("By a quadtree there are about as many triangles as equilateral ones of the size fit")
    {
        const MeshDomain domain = square_with_hole(50, 0.0);
        const CellMesh mesh = tree_mesh(domain, {.size = 0.02});
        const double n = domain.area() / (0.25 * std::numbers::sqrt3 * 0.02 * 0.02);
        CHECK(static_cast<double>(mesh.cells.size()) == Approx(n).epsilon(0.15));
    }

    TEST_CASE("By a quadtree random stars with the sharpest corners are filled")
    {
        std::mt19937 random(12);
        for (int i = 0; i < 300; ++i) {
            const MeshDomain domain = random_star(random);
            CAPTURE(i);
            check_triangles(domain, tree_mesh(domain, {.size = 0.2}));
        }
    }

    TEST_CASE("By a quadtree a long thin strip, whose parts are long beside its width, is filled")
    {
        const MeshDomain domain = polygon({{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {2.0, 1e-3}, {0.9, 1e-3}, {0.0, 1e-3}});
        check_triangles(domain, tree_mesh(domain, {.size = 0.5}));
    }

    TEST_CASE("By a quadtree segments inside become edges, and single places nodes")
    {
        MeshDomain domain = square_with_hole(8, 0.0);
        const auto first = static_cast<CellNode>(domain.nodes.size());
        for (const FlatPoint& at : {FlatPoint{0.31, 0.43}, {0.42, 0.49}, {0.55, 0.52}, {0.8, 0.17}})
            domain.nodes.push_back(at);
        domain.segments = {{first, first + 1}, {first + 1, first + 2}};
        const CellMesh mesh = tree_mesh(domain, {.size = 0.125});
        CHECK(area(mesh) == Approx(1.0).epsilon(1e-12));
        check_edges(domain, mesh);
        CHECK(std::any_of(mesh.cells.begin(), mesh.cells.end(),
                          [&](const Cell& cell) { return std::ranges::count(cell.nodes(), first + 3) == 1; }));
    }

    TEST_CASE("No square inside has a side against more than two others, and none is larger than asked for")
    {
        MeshDomain domain = square_with_hole(4, 0.3);
        for (const CellNode node : domain.loops[1]) domain.nodes[node] = domain.nodes[node] + FlatVector{0.13, 0.11};
        domain.nodes.push_back({0.08, 0.1});
        std::vector<double> sizes(domain.nodes.size());
        sizes.back() = 0.002;
        QuadtreeMesher mesher(domain, {.size = 0.25, .sizes = sizes});
        CHECK(area(mesher.run()) == Approx(domain.area()).epsilon(1e-12));
        const Quadtree& tree = mesher.tree();
        for (Quadtree::Index leaf = 0; leaf < tree.size(); ++leaf) {
            if (!tree[leaf].is_leaf()) continue;
            const FlatBox box = tree.box(leaf);
            const FlatPoint centre = middle(box.low, box.high);
            const bool is_in_hole = distance(centre, {0.63, 0.61}) < 0.3 + tree.side(leaf);
            const bool is_in_square = FlatBox{{0.0, 0.0}, {1.0, 1.0}}.has(centre);
            if (is_in_hole || !is_in_square) continue;
            CHECK(tree.side(leaf) <= 0.25);
            for (const double up : {0.25, 0.75}) { // beside its right side
                const Quadtree::Square& here = tree[leaf];
                const auto y = here.y + static_cast<Quadtree::Step>(up * static_cast<double>(here.side()));
                const Quadtree::Step x = here.x + here.side();
                if (!Quadtree::has(x, y)) continue;
                CHECK(tree[tree.leaf_at(x, y)].level <= here.level + 1);
            }
        }
    }

    TEST_CASE("By a quadtree outlines that cross are told")
    {
        CHECK_THROWS_AS(tree_mesh(polygon({{0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}})), CrossingEdges);
    }
}
