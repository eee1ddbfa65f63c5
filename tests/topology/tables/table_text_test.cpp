// The lecture's dumps, with its slips mended: LOUT, no bullets, and two cells after the second MEV.
#include <doctest/doctest.h>

#include "topology/halfedge/operators/euler_operator.h"
#include "topology/tables/table_text.h"

using namespace topology;

TEST_SUITE("tables")
{
    TEST_CASE("The lecture's tables after MVFS, MEV and a second MEV")
    {
        Solid solid;
        EulerOperator op(solid);
        const LoneVertex first = op.mvfs({0, 0, 0});
        CHECK(table_text(solid) == "V = 1 (H = 1) N = 0 P = 0\n"
                                   "H = 1 (V = 1, E = 0, L = 1) N = 0 P = 0\n"
                                   "E = 0 (H1 = 0, H2 = 0) N = 0 P = 0\n"
                                   "L = 1 (H = 1, F = 1) N = 0 P = 0\n"
                                   "F = 1 (S = 1, LOUT = 0 / LOOPS = 1) N = 0 P = 0\n"
                                   "S = 1 (V = 1, F = 1, E = 0) N = 0 P = 0\n");
        const NewEdge edge = op.mev(first.half_edge, {1, 0, 0});
        CHECK(table_text(solid) == "V = 1 (H = 1) N = 0 P = 2\n"
                                   "V = 2 (H = 2) N = 1 P = 0\n"
                                   "H = 1 (V = 1, E = 1, L = 1) N = 2 P = 2\n"
                                   "H = 2 (V = 2, E = 1, L = 1) N = 1 P = 1\n"
                                   "E = 1 (H1 = 2, H2 = 1) N = 0 P = 0\n"
                                   "L = 1 (H = 2, F = 1) N = 0 P = 0\n"
                                   "F = 1 (S = 1, LOUT = 0 / LOOPS = 1) N = 0 P = 0\n"
                                   "S = 1 (V = 1, F = 1, E = 1) N = 0 P = 0\n");
        op.mev(edge.plus, {2, 0, 0});
        CHECK(table_text(solid) == "V = 1 (H = 1) N = 0 P = 2\n"
                                   "V = 2 (H = 2) N = 1 P = 3\n"
                                   "V = 3 (H = 4) N = 2 P = 0\n"
                                   "H = 1 (V = 1, E = 1, L = 1) N = 3 P = 2\n"
                                   "H = 2 (V = 2, E = 1, L = 1) N = 1 P = 4\n"
                                   "H = 3 (V = 2, E = 2, L = 1) N = 4 P = 1\n"
                                   "H = 4 (V = 3, E = 2, L = 1) N = 2 P = 3\n"
                                   "E = 1 (H1 = 2, H2 = 1) N = 0 P = 2\n"
                                   "E = 2 (H1 = 4, H2 = 3) N = 1 P = 0\n"
                                   "L = 1 (H = 2, F = 1) N = 0 P = 0\n"
                                   "F = 1 (S = 1, LOUT = 0 / LOOPS = 1) N = 0 P = 0\n"
                                   "S = 1 (V = 1, F = 1, E = 1) N = 0 P = 0\n");
    }

    TEST_CASE("The first MEF bounds both faces, and a ring stands beside the older loops of its face alone")
    {
        Solid solid;
        EulerOperator op(solid);
        const LoneVertex first = op.mvfs({0, 0, 0});
        const HalfEdgeId b = op.mev(first.half_edge, {1, 0, 0}).plus, c = op.mev(b, {0, 1, 0}).plus;
        op.mef(first.half_edge, c);
        op.mvr(first.face, {0.3, 0.3, 0});
        const std::string text = table_text(solid, {.number = 2, .older = 1, .newer = 3});
        CHECK(text.find("L = 1 (H = 4, F = 1) N = 0 P = 3\n") == std::string::npos);
        CHECK(text.find("F = 1 (S = 2, LOUT = 1 / LOOPS = 1) N = 0 P = 2\n") != std::string::npos);
        CHECK(text.find("F = 2 (S = 2, LOUT = 2 / LOOPS = 2) N = 1 P = 0\n") != std::string::npos);
        CHECK(text.find("L = 2 (H = 5, F = 2) N = 0 P = 0\n") != std::string::npos);
        CHECK(text.find("L = 3 (H = 7, F = 1) N = 1 P = 0\n") != std::string::npos);
        CHECK(text.find("S = 2 (V = 1, F = 1, E = 1) N = 1 P = 3\n") != std::string::npos);
    }
}
