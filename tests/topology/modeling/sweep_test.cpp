#include <doctest/doctest.h>

#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"
#include "topology/modeling/sweep.h"

using namespace topology;

TEST_SUITE("sweep")
{
    TEST_CASE("A face of n corners makes n vertices, 2 n edges and n faces, and ends as the moved face")
    {
        for (int n = 2; n <= 7; ++n) {
            CAPTURE(n);
            Solid solid;
            EulerOperator op(solid);
            const LoneVertex first = op.mvfs({0, 0, 0});
            HalfEdgeId corner = first.half_edge;
            for (int i = 1; i < n; ++i) corner = op.mev(corner, {1.0 * i, 0.5 * i * i, 0}).plus;
            op.mef(first.half_edge, corner);
            const std::size_t N = static_cast<std::size_t>(n);
            const Sweep made = sweep(op, first.face, {0, 0, 3});
            validate(solid);
            CHECK(euler_counts(solid) == EulerCounts{.V = 2 * N, .E = 3 * N, .F = N + 2, .L = N + 2, .S = 1, .G = 0});
            CHECK(made.sides.size() == N);
            for (const HalfEdgeId h : solid.chain(solid.outer(first.face))) CHECK(solid.point(solid.start(h)).z == 3);
            for (const SweptSide& side : made.sides) {
                int length = 0;
                for ([[maybe_unused]] const HalfEdgeId h : solid.chain(solid.outer(side.face))) ++length;
                CHECK(length == 4);
            }
        }
    }

    TEST_CASE("Rings are swept too, a lone vertex becomes a strut, a single closed edge is refused")
    {
        Solid solid;
        EulerOperator op(solid);
        const LoneVertex first = op.mvfs({0, 0, 0});
        HalfEdgeId corner = first.half_edge;
        for (int i = 1; i < 4; ++i) corner = op.mev(corner, {1.0 * i, 0.5 * i * i, 0}).plus;
        op.mef(first.half_edge, corner);
        const LoneVertex lone = op.mvr(first.face, {5, 5, 0});
        const Sweep made = sweep(op, first.face, {0, 0, 2});
        CHECK(made.vertices.size() == 5);
        CHECK(made.vertices.back().from == lone.vertex);
        CHECK(euler_counts(solid) == EulerCounts{.V = 10, .E = 13, .F = 6, .L = 7, .S = 1, .G = 0});
        const LoopId ring = op.mvr(first.face, {6, 6, 2}).loop;
        const HalfEdgeId h = solid.half_edge(ring);
        op.mef(h, h);
        const Solid before = solid;
        CHECK_THROWS_AS(sweep(op, first.face, {0, 0, 2}), EulerError);
        CHECK(solid == before);
    }
}
