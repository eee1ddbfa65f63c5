#include <doctest/doctest.h>

#include <array>
#include <string>

#include "topology/halfedge/check/validate.h"
#include "topology/halfedge/operators/euler_operator.h"
#include "topology/mesh/assembly.h"
#include "topology/tables/winged_edge.h"

using namespace topology;

namespace {

/// The planar subdivision of the lecture: three triangles and a fourth beside them, of six vertices and nine edges.
///
///    1 -- 6 -- 5
///    | 1 / \ 4 |        faces 1 to 4, and 0 around them
///    |  / 2 \3\|
///    2 -- 3 -- 4
constexpr std::array<Point, 6> points{{{0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}}};
constexpr std::array<std::array<std::uint32_t, 2>, 9> ends{
    {{1, 2}, {2, 6}, {6, 3}, {6, 4}, {4, 5}, {2, 3}, {3, 4}, {5, 6}, {6, 1}}};
constexpr std::array<std::uint32_t, 6> edge_of_vertex{1, 6, 7, 4, 8, 2};
constexpr std::array<std::uint32_t, 5> edge_of_face{1, 2, 6, 4, 4};

/// Halves 2e and 2e + 1 run along edge e and against it.
HalfEdgeId half(std::uint32_t from, std::uint32_t to)
{
    for (std::uint32_t e = 0; e < ends.size(); ++e) {
        if (ends[e] == std::array{from, to}) return {2 * e};
        if (ends[e] == std::array{to, from}) return {2 * e + 1};
    }
    FAIL("no edge");
    return {};
}

void add_face(Tables& t, const std::vector<std::uint32_t>& vertices)
{
    const LoopId l{static_cast<std::uint32_t>(t.loops.n_rows())};
    const FaceId f = t.faces.add({l});
    const std::size_t n = vertices.size();
    for (std::size_t i = 0; i < n; ++i) {
        const HalfEdgeId h = half(vertices[i], vertices[(i + 1) % n]),
                         next = half(vertices[(i + 1) % n], vertices[(i + 2) % n]);
        t.half_edges[h].loop = l;
        t.half_edges[h].next = next;
        t.half_edges[next].prev = h;
        if (EdgeId{h.index / 2} == EdgeId{edge_of_face[f.index] - 1}) t.loops.add({h, f, l, l});
    }
}

Solid lecture_subdivision()
{
    Tables t;
    for (std::uint32_t e = 0; e < ends.size(); ++e) {
        t.edges.add({HalfEdgeId{2 * e}, HalfEdgeId{2 * e + 1}});
        for (const std::uint32_t v : ends[e]) t.half_edges.add({VertexId{v - 1}, EdgeId{e}});
    }
    for (std::uint32_t v = 0; v < points.size(); ++v) {
        const std::uint32_t e = edge_of_vertex[v] - 1;
        t.vertices.add({HalfEdgeId{2 * e + (ends[e][0] == v + 1 ? 0U : 1U)}, points[v]});
    }
    add_face(t, {1, 6, 5, 4, 3, 2});
    add_face(t, {1, 2, 6});
    add_face(t, {2, 3, 6});
    add_face(t, {6, 3, 4});
    add_face(t, {4, 5, 6});
    return Assembly(t).solid();
}

} // namespace

TEST_SUITE("winged edge")
{
    TEST_CASE("The lecture's planar subdivision has the lecture's winged-edge tables")
    {
        const Solid solid = lecture_subdivision();
        REQUIRE_FALSE(why_not_valid(solid));
        CHECK(winged_text(solid, FaceId{0}) == "v x y z eI\n"
                                               "1 0 1 0 1\n"
                                               "2 0 0 0 6\n"
                                               "3 1 0 0 7\n"
                                               "4 2 0 0 4\n"
                                               "5 2 1 0 8\n"
                                               "6 1 1 0 2\n"
                                               "f eI\n"
                                               "0 1\n"
                                               "1 2\n"
                                               "2 6\n"
                                               "3 4\n"
                                               "4 4\n"
                                               "e vI vF fL fR eLP eLN eRP eRN\n"
                                               "1 1 2 1 0 9 2 6 9\n"
                                               "2 2 6 1 2 1 9 3 6\n"
                                               "3 6 3 3 2 4 7 6 2\n"
                                               "4 6 4 4 3 8 5 7 3\n"
                                               "5 4 5 4 0 4 8 8 7\n"
                                               "6 2 3 2 0 2 3 7 1\n"
                                               "7 3 4 3 0 3 4 5 6\n"
                                               "8 5 6 4 0 5 4 9 5\n"
                                               "9 6 1 1 0 2 1 1 8\n");
    }

    TEST_CASE("A lone vertex and a ring have no edge to name, and a ring adds one to its face's row")
    {
        Solid solid;
        EulerOperator op(solid);
        const LoneVertex first = op.mvfs({0, 0, 0});
        const HalfEdgeId a = op.mev(first.half_edge, {4, 0, 0}).plus, b = op.mev(a, {0, 4, 0}).plus;
        op.mef(first.half_edge, b);
        op.mvr(first.face, {1, 1, 0});
        const WingedTables tables(solid);
        CHECK(tables.vertex(tables.n_vertices() - 1).cells.front().number == 0);
        CHECK_FALSE(tables.vertex(tables.n_vertices() - 1).cells.front().link);
        CHECK(tables.face(0).cells.size() == 2);
        CHECK(tables.face(0).cells.back().number == 0);
        CHECK(tables.edge(0).cells.size() == 8);
        CHECK(*tables.edge(0).cells.front().link == Entity(solid.start(solid.plus(EdgeId{0}))));
    }
}
