#include "topology/meshing/mapped_mesher.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/topology/meshing/mesh_figures.h"
#include "topology/meshing/row_mesher.h"

using namespace topology;
using doctest::Approx;

namespace {

struct Mapped {
    std::vector<FlatPoint> nodes;
    MappedSides sides;

    CellNode add(const FlatPoint& at)
    {
        nodes.push_back(at);
        return static_cast<CellNode>(nodes.size() - 1);
    }
    /// From one corner to another, the places between them by a function of the share.
    template <class Place> void side(std::size_t i, CellNode from, CellNode to, std::size_t n, const Place& place)
    {
        sides[i] = {from};
        for (std::size_t k = 1; k < n; ++k)
            sides[i].push_back(add(place(static_cast<double>(k) / static_cast<double>(n))));
        sides[i].push_back(to);
    }
    void straight(std::size_t i, CellNode from, CellNode to, std::size_t n)
    {
        const FlatPoint a = nodes[from], b = nodes[to];
        side(i, from, to, n, [&](double share) { return a + share * (b - a); });
    }
};

Mapped quadrilateral(const std::array<FlatPoint, 4>& corners, std::size_t n_across, std::size_t n_up)
{
    Mapped mapped;
    for (const FlatPoint& corner : corners) mapped.add(corner);
    mapped.straight(0, 0, 1, n_across);
    mapped.straight(1, 1, 2, n_up);
    mapped.straight(2, 2, 3, n_across);
    mapped.straight(3, 3, 0, n_up);
    return mapped;
}

} // namespace

TEST_SUITE("mapped meshes")
{
    TEST_CASE("Nodes in a quadrilateral with straight sides, evenly divided, are where the bilinear map has them")
    {
        const std::array<FlatPoint, 4> c{{{0.0, 0.0}, {7.0, 1.0}, {6.0, 5.0}, {-1.0, 3.0}}};
        Mapped mapped = quadrilateral(c, 5, 3);
        const auto rows = mapped_nodes(mapped.sides, mapped.nodes);
        REQUIRE(rows.size() == 4);
        for (std::size_t j = 0; j < rows.size(); ++j)
            for (std::size_t i = 0; i < rows[j].size(); ++i) {
                const double u = static_cast<double>(i) / 5.0, v = static_cast<double>(j) / 3.0;
                const FlatPoint below = c[0] + u * (c[1] - c[0]), above = c[3] + u * (c[2] - c[3]);
                CHECK(distance(mapped.nodes[rows[j][i]], below + v * (above - below)) < 1e-13);
            }
        const CellMesh mesh{mapped.nodes, quadrilaterals(rows)};
        CHECK(mesh.cells.size() == 15);
        CHECK(area(mesh) == Approx(0.5 * (turn(c[0], c[1], c[2]) + turn(c[0], c[2], c[3]))).epsilon(1e-13));
    }

    TEST_CASE("Nodes in a quarter of a ring lie on circles and on rays")
    {
        Mapped mapped;
        const double quarter = 0.5 * std::numbers::pi;
        const auto polar = [](double r, double angle) { return FlatPoint{r * std::cos(angle), r * std::sin(angle)}; };
        const CellNode a = mapped.add(polar(1.0, 0.0)), b = mapped.add(polar(2.0, 0.0)),
                       c = mapped.add(polar(2.0, quarter)), d = mapped.add(polar(1.0, quarter));
        mapped.straight(0, a, b, 4);
        mapped.side(1, b, c, 6, [&](double share) { return polar(2.0, share * quarter); });
        mapped.straight(2, c, d, 4);
        mapped.side(3, d, a, 6, [&](double share) { return polar(1.0, (1.0 - share) * quarter); });
        const auto rows = mapped_nodes(mapped.sides, mapped.nodes);
        for (std::size_t j = 0; j < rows.size(); ++j)
            for (std::size_t i = 0; i < rows[j].size(); ++i) {
                const double r = 1.0 + static_cast<double>(i) / 4.0, angle = static_cast<double>(j) / 6.0 * quarter;
                CHECK(distance(mapped.nodes[rows[j][i]], polar(r, angle)) < 1e-12);
            }
    }

    TEST_CASE("Triangles by either diagonal, the shorter one or both fill the same area")
    {
        Mapped mapped = quadrilateral({{{0.0, 0.0}, {7.0, 1.0}, {6.0, 5.0}, {-1.0, 3.0}}}, 3, 2);
        const auto cells = quadrilaterals(mapped_nodes(mapped.sides, mapped.nodes));
        const double whole = area({mapped.nodes, cells});
        for (const Diagonal diagonal : {Diagonal::Right, Diagonal::Left, Diagonal::Shortest, Diagonal::Cross}) {
            std::vector<FlatPoint> nodes = mapped.nodes;
            const auto cut = triangles(cells, diagonal, nodes);
            CHECK(cut.size() == (diagonal == Diagonal::Cross ? 4 : 2) * cells.size());
            CHECK(area({nodes, cut}) == Approx(whole).epsilon(1e-13));
        }
        const auto first = cells[0].nodes();
        CHECK(triangles(cells, Diagonal::Right, mapped.nodes)[0] == Cell(first[0], first[1], first[2]));
        CHECK(triangles(cells, Diagonal::Left, mapped.nodes)[0] == Cell(first[0], first[1], first[3]));
    }

    TEST_CASE("A straight side that is swept makes the bilinear map's nodes")
    {
        Mapped mapped = quadrilateral({{{0.0, 0.0}, {7.0, 1.0}, {6.0, 5.0}, {-1.0, 3.0}}}, 5, 3), swept = mapped;
        mapped_nodes(mapped.sides, mapped.nodes);
        swept_nodes(swept.sides, swept.nodes);
        REQUIRE(swept.nodes.size() == mapped.nodes.size());
        for (std::size_t i = 0; i < swept.nodes.size(); ++i) CHECK(distance(swept.nodes[i], mapped.nodes[i]) < 1e-13);
    }

    TEST_CASE(
        "A bent side that is swept around a quarter of a ring stays the same line on every ray, which no map does")
    {
        // the source at angle 0, bent by h sin(pi s) to one side, and the target, the same line on the other ray
        constexpr double quarter = 0.5 * std::numbers::pi, h = 0.3, r = 2.0;
        const auto bent = [&](double share, double angle) {
            const double x = r + share, y = h * std::sin(std::numbers::pi * share);
            return FlatPoint{x * std::cos(angle) - y * std::sin(angle), x * std::sin(angle) + y * std::cos(angle)};
        };
        const auto arc = [&](double radius, double angle) {
            return FlatPoint{radius * std::cos(angle), radius * std::sin(angle)};
        };
        Mapped swept;
        const CellNode a = swept.add(bent(0.0, 0.0)), b = swept.add(bent(1.0, 0.0)), c = swept.add(bent(1.0, quarter)),
                       d = swept.add(bent(0.0, quarter));
        swept.side(0, a, b, 4, [&](double share) { return bent(share, 0.0); });
        swept.side(1, b, c, 6, [&](double share) { return arc(r + 1.0, share * quarter); });
        swept.side(2, c, d, 4, [&](double share) { return bent(1.0 - share, quarter); });
        swept.side(3, d, a, 6, [&](double share) { return arc(r, (1.0 - share) * quarter); });
        Mapped mapped = swept;
        const auto rows = swept_nodes(swept.sides, swept.nodes);
        mapped_nodes(mapped.sides, mapped.nodes);
        double farthest = 0.0;
        for (std::size_t j = 0; j < rows.size(); ++j)
            for (std::size_t i = 0; i < rows[j].size(); ++i) {
                const FlatPoint wanted = bent(static_cast<double>(i) / 4.0, static_cast<double>(j) / 6.0 * quarter);
                CHECK(distance(swept.nodes[rows[j][i]], wanted) < 1e-12);
                farthest = std::max(farthest, distance(mapped.nodes[rows[j][i]], wanted));
            }
        CHECK(farthest > 0.01);
    }

    TEST_CASE("A mapped mesh is laid row by row")
    {
        Mapped mapped = quadrilateral({{{0.0, 0.0}, {7.0, 1.0}, {6.0, 5.0}, {-1.0, 3.0}}}, 5, 3);
        const auto cells = quadrilaterals(mapped_nodes(mapped.sides, mapped.nodes));
        RowMesher mesher(mapped.nodes, in_rows(cells, [](std::size_t) { return 5; }));
        for (std::size_t n = 1; n <= 3; ++n) {
            CHECK(mesher.next() == MeshStep::Row);
            CHECK(mesher.mesh().cells.size() == 5 * n);
            CHECK(mesher.marks().cells.size() == 5);
        }
        CHECK(mesher.next() == MeshStep::Done);
        CHECK(mesher.mesh().cells == cells);
    }
}
