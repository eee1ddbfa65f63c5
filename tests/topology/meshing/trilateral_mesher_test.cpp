#include "topology/meshing/trilateral_mesher.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "tests/topology/meshing/mesh_figures.h"

using namespace topology;
using doctest::Approx;

namespace {

struct Trilateral {
    std::vector<FlatPoint> nodes;
    TrilateralSides sides;

    /// Each side by the place at a share of it.
    Trilateral(std::size_t n, const std::function<FlatPoint(std::size_t side, double share)>& place)
    {
        for (std::size_t side = 0; side < 3; ++side)
            for (std::size_t i = 0; i < n; ++i) {
                sides[side].push_back(static_cast<CellNode>(nodes.size()));
                nodes.push_back(place(side, static_cast<double>(i) / static_cast<double>(n)));
            }
        for (std::size_t side = 0; side < 3; ++side) sides[side].push_back(sides[(side + 1) % 3].front());
    }
};

constexpr FlatPoint corners[] = {{0.0, 0.0}, {7.0, 1.0}, {2.0, 5.0}};

Trilateral triangle(std::size_t n)
{
    return {n, [](std::size_t side, double share) {
                return corners[side] + share * (corners[(side + 1) % 3] - corners[side]);
            }};
}

/// A sector of 80 degrees of a circle of radius 2 about the first corner.
Trilateral sector(std::size_t n)
{
    return {n, [](std::size_t side, double share) {
                const double radius = side == 0 ? 2.0 * share : side == 1 ? 2.0 : 2.0 * (1.0 - share);
                const double angle = (side == 0 ? 0.0 : side == 1 ? share : 1.0) * 80.0 / 180.0 * std::numbers::pi;
                return FlatPoint{radius * std::cos(angle), radius * std::sin(angle)};
            }};
}

} // namespace

TEST_SUITE("trilateral meshes")
{
    TEST_CASE("Nodes in a triangle with straight sides are where the linear map has them")
    {
        Trilateral given = triangle(5);
        const auto rows = trilateral_nodes(given.sides, given.nodes);
        REQUIRE(rows.size() == 6);
        for (std::size_t w = 0; w < rows.size(); ++w) {
            REQUIRE(rows[w].size() == 6 - w);
            for (std::size_t v = 0; v < rows[w].size(); ++v) {
                const FlatPoint wanted = corners[0] + static_cast<double>(v) / 5.0 * (corners[1] - corners[0]) +
                                         static_cast<double>(w) / 5.0 * (corners[2] - corners[0]);
                CHECK(distance(given.nodes[rows[w][v]], wanted) < 1e-13);
            }
        }
    }

    TEST_CASE("n parts of a side make n * n triangles that fill the region, straight or round")
    {
        for (const std::size_t n : {1U, 2U, 3U, 8U})
            for (Trilateral given : {triangle(n), sector(n)}) {
                CAPTURE(n);
                const MeshDomain domain = polygon(given.nodes);
                const auto rows = trilateral_nodes(given.sides, given.nodes);
                const CellMesh mesh{given.nodes, trilateral_triangles(rows)};
                CHECK(mesh.cells.size() == n * n);
                check_triangles(domain, mesh);
            }
    }

    TEST_CASE("An even number of parts n makes 3 (n / 2)^2 quadrilaterals: V = Q + B / 2 + 1, none poor")
    {
        for (const std::size_t n : {2U, 4U, 10U})
            for (Trilateral given : {triangle(n), sector(n)}) {
                CAPTURE(n);
                const MeshDomain domain = polygon(given.nodes);
                CellMesh mesh;
                for (const MappedSides& part : trilateral_parts(given.sides, given.nodes)) {
                    const auto cells = quadrilaterals(mapped_nodes(part, given.nodes));
                    mesh.cells.insert(mesh.cells.end(), cells.begin(), cells.end());
                }
                mesh.nodes = given.nodes;
                CHECK(mesh.cells.size() == 3 * (n / 2) * (n / 2));
                CHECK(mesh.nodes.size() == mesh.cells.size() + domain.nodes.size() / 2 + 1);
                CHECK(area(mesh) == Approx(domain.area()).epsilon(1e-12));
                check_edges(domain, mesh);
                CHECK(smallest_angle(mesh) > 20.0);
            }
    }
}
