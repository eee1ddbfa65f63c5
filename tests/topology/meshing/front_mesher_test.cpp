#include "topology/meshing/front_mesher.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "tests/topology/meshing/mesh_figures.h"

using namespace topology;
using doctest::Approx;

namespace {

CellMesh front_mesh(const MeshDomain& domain, const MesherOptions& options = {})
{
    return FrontMesher(domain, options).run();
}

} // namespace

TEST_SUITE("meshes by an advancing front")
{
    TEST_CASE("By an advancing front a square and a square with a hole are filled, no angle below 25 degrees")
    {
        for (const double radius : {0.0, 0.2, 0.05}) {
            const MeshDomain domain = square_with_hole(10, radius);
            const CellMesh mesh = front_mesh(domain, {.size = 0.1});
            CAPTURE(radius);
            check_triangles(domain, mesh);
            CHECK(smallest_angle(mesh) >= 25.0);
        }
    }

    TEST_CASE("By an advancing front there are about as many triangles as equilateral ones of the size fit")
    {
        const MeshDomain domain = square_with_hole(50, 0.0);
        const CellMesh mesh = front_mesh(domain, {.size = 0.02});
        const double n = domain.area() / (0.25 * std::numbers::sqrt3 * 0.02 * 0.02);
        CHECK(static_cast<double>(mesh.cells.size()) == Approx(n).epsilon(0.15));
    }

    TEST_CASE("By an advancing front random stars with the sharpest corners are filled")
    {
        std::mt19937 random(12);
        for (int i = 0; i < 300; ++i) {
            const MeshDomain domain = random_star(random);
            CAPTURE(i);
            check_triangles(domain, front_mesh(domain, {.size = 0.2}));
        }
    }

    TEST_CASE("By an advancing front a long thin strip, whose parts are long beside its width, is filled")
    {
        const MeshDomain domain = polygon({{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}, {2.0, 1e-3}, {0.9, 1e-3}, {0.0, 1e-3}});
        check_triangles(domain, front_mesh(domain, {.size = 0.5}));
    }

    TEST_CASE("Segments inside become edges, which the front leaves on both sides, and single places nodes")
    {
        MeshDomain domain = square_with_hole(8, 0.0);
        const auto first = static_cast<CellNode>(domain.nodes.size());
        for (const FlatPoint& at : {FlatPoint{0.31, 0.43}, {0.42, 0.49}, {0.55, 0.52}, {0.8, 0.17}})
            domain.nodes.push_back(at);
        domain.segments = {{first, first + 1}, {first + 1, first + 2}};
        const CellMesh mesh = front_mesh(domain, {.size = 0.125});
        CHECK(area(mesh) == Approx(1.0).epsilon(1e-12));
        check_edges(domain, mesh);
        CHECK(std::any_of(mesh.cells.begin(), mesh.cells.end(),
                          [&](const Cell& cell) { return std::ranges::count(cell.nodes(), first + 3) == 1; }));
    }

    TEST_CASE("At every step the triangles behind the front and the area that it encloses are the domain")
    {
        const MeshDomain domain = square_with_hole(6, 0.2);
        FrontMesher mesher(domain, {.size = 0.15});
        double longest_first = 0.0;
        std::size_t n_triangles = 0;
        for (MeshStep step = mesher.next(); step != MeshStep::Smoothed; step = mesher.next()) {
            if (step != MeshStep::FrontPoint && step != MeshStep::FrontNode) continue;
            const CellMesh mesh = mesher.mesh();
            CHECK(mesh.cells.size() == ++n_triangles); // one a step
            double twice = 0.0;
            for (const auto& [a, b] : mesher.front()) twice += turn({0.0, 0.0}, mesh.nodes[a], mesh.nodes[b]);
            CHECK(area(mesh) + 0.5 * twice == Approx(domain.area()).epsilon(1e-12));
            longest_first = std::max(longest_first, length(mesher.marks().edges[0][1] - mesher.marks().edges[0][0]));
        }
        CHECK(n_triangles > 40);
        CHECK(longest_first < 0.5);
    }

    TEST_CASE("By an advancing front outlines that cross are told")
    {
        CHECK_THROWS_AS(front_mesh(polygon({{0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}, {0.0, 1.0}})), CrossingEdges);
    }
}
