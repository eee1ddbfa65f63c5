#include <doctest/doctest.h>

#include <algorithm>

#include "topology/halfedge/operators/euler_operator.h"
#include "topology/tables/pointer_graph.h"

using namespace topology;

namespace {

bool has(const std::vector<Pointer>& pointers, const Pointer& pointer)
{
    return std::find(pointers.begin(), pointers.end(), pointer) != pointers.end();
}

} // namespace

TEST_SUITE("pointer graph")
{
    TEST_CASE("A half-edge points at its start, loop, next, prev, mate and edge, and its neighbours point back")
    {
        Solid solid;
        EulerOperator op(solid);
        const LoneVertex first = op.mvfs({0, 0, 0});
        const NewEdge a = op.mev(first.half_edge, {4, 0, 0}), b = op.mev(a.plus, {0, 4, 0});
        op.mef(first.half_edge, b.plus);
        const PointerGraph graph = pointer_graph(solid, a.minus);
        CHECK(graph.nodes.front() == Entity(a.minus));
        CHECK(graph.nodes.size() == 7);
        CHECK(pointers(solid, a.minus).size() == 6);
        CHECK(has(graph.pointers, {a.minus, b.minus, "next"}));
        CHECK(has(graph.pointers, {b.minus, a.minus, "prev"}));
        CHECK(has(graph.pointers, {a.plus, a.minus, "mate"}));
        CHECK(has(graph.pointers, {a.edge, a.minus, "minus"}));
        CHECK(pointer_graph(solid, a.minus, 2).nodes.size() > graph.nodes.size());
    }

    TEST_CASE("A face points at its outer loop and at its rings, and a lone vertex's half-edge at itself")
    {
        Solid solid;
        EulerOperator op(solid);
        const LoneVertex first = op.mvfs({0, 0, 0});
        const LoneVertex ring = op.mvr(first.face, {1, 1, 0});
        CHECK(pointers(solid, first.face) ==
              std::vector<Pointer>{{first.face, first.loop, "outer"}, {first.face, ring.loop, "ring"}});
        CHECK(has(pointers(solid, ring.half_edge), {ring.half_edge, ring.half_edge, "next"}));
        CHECK(pointers(solid, ring.half_edge).size() == 5);
        CHECK(pointer_graph(solid, ring.vertex, 9).nodes.size() == 7);
    }
}
