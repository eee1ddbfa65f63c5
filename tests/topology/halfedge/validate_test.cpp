#include <doctest/doctest.h>

#include <set>
#include <string>

#include "tests/topology/halfedge/random_walk.h"
#include "topology/halfedge/check/corrupted_solid.h"
#include "topology/halfedge/check/validate.h"

using namespace topology;

namespace {

std::size_t n_rows_of(const Solid& solid, LinkKind kind)
{
    if (kind <= LinkKind::HalfEdgePrev) return solid.half_edges().n_rows();
    if (kind <= LinkKind::EdgeMinus) return solid.edges().n_rows();
    if (kind == LinkKind::VertexHalfEdge) return solid.vertices().n_rows();
    return kind <= LinkKind::LoopPrev ? solid.loops().n_rows() : solid.faces().n_rows();
}

bool lives(const Solid& solid, LinkKind kind, std::uint32_t row)
{
    if (kind <= LinkKind::HalfEdgePrev) return solid.has(HalfEdgeId{row});
    if (kind <= LinkKind::EdgeMinus) return solid.has(EdgeId{row});
    if (kind == LinkKind::VertexHalfEdge) return solid.has(VertexId{row});
    return kind <= LinkKind::LoopPrev ? solid.has(LoopId{row}) : solid.has(FaceId{row});
}

/// A vertex may name any of its half-edges, and a loop any of its chain: such a change is no fault.
bool is_harmless(const Solid& solid, const CorruptedLink& link)
{
    const HalfEdgeId to{link.to};
    if (link.kind == LinkKind::VertexHalfEdge) return solid.has(to) && solid.start(to) == VertexId{link.row};
    if (link.kind == LinkKind::LoopHalfEdge) return solid.has(to) && solid.loop(to) == LoopId{link.row};
    if (link.kind == LinkKind::FaceOuter)
        return solid.has(LoopId{link.to}) && solid.face(LoopId{link.to}) == FaceId{link.row};
    return false;
}

} // namespace

TEST_SUITE("validate")
{
    TEST_CASE("Every kind of link, bent to another entity, to a dead one or to none, is seen")
    {
        std::set<std::pair<LinkKind, Invariant>> seen;
        for (std::uint32_t seed = 1; seed <= 400; ++seed) {
            RandomWalk walk(seed);
            for (int i = 0; i < 60; ++i) walk.step(1.5);
            const Solid& solid = walk.solid;
            for (int k = 0; k < n_link_kinds; ++k) {
                const auto kind = static_cast<LinkKind>(k);
                CorruptedLink link{.kind = kind, .row = walk.below(n_rows_of(solid, kind) + 1), .to = walk.below(60)};
                if (walk.below(20) == 0) link.to = nothing<VertexId>.index;
                if (!lives(solid, kind, link.row) || is_harmless(solid, link)) continue;
                const CorruptedSolid broken(solid, link);
                if (broken.solid() == solid) continue;
                CAPTURE(seed);
                CAPTURE(k);
                CAPTURE(link.row);
                CAPTURE(link.to);
                const auto breach = why_not_valid(broken.solid());
                REQUIRE(breach);
                CHECK_THROWS_WITH_AS(validate(broken.solid()), sentence(*breach).c_str(), BrokenInvariant);
                seen.insert({kind, breach->invariant});
            }
        }
        for (int k = 0; k < n_link_kinds; ++k) {
            CAPTURE(k);
            CHECK(std::any_of(seen.begin(), seen.end(),
                              [&](const auto& pair) { return pair.first == static_cast<LinkKind>(k); }));
        }
    }

    TEST_CASE("A vertex whose half-edges fall into two fans is named, though every link has its counterpart")
    {
        Solid solid;
        EulerOperator op(solid);
        const VertexId a = op.mvfs({0, 0, 0}).vertex, b = op.mvfs({1, 0, 0}).vertex;
        // The half-edge of b says that it starts at a: no link contradicts it, but turning about a does not meet it.
        const CorruptedSolid pinched(solid,
                                     {.kind = LinkKind::HalfEdgeStart, .row = solid.half_edge(b).index, .to = a.index});
        const CorruptedSolid both(pinched.solid(), {.kind = LinkKind::VertexHalfEdge, .row = b.index, .to = a.index});
        CHECK(why_not_valid(pinched.solid())->invariant == Invariant::HalfOfVertex);
        CHECK(why_not_valid(both.solid())->invariant == Invariant::HalfOfVertex);
    }

    TEST_CASE("The sentence names the entities as the tables do")
    {
        Solid solid;
        EulerOperator op(solid);
        op.mev(op.mvfs({0, 0, 0}).half_edge, {1, 0, 0});
        const CorruptedSolid broken(solid, {.kind = LinkKind::HalfEdgeNext, .row = 0, .to = 0});
        CHECK(sentence(*why_not_valid(broken.solid())) ==
              "he1 and he1 are neighbours for one of them alone: next and prev disagree");
        CHECK_FALSE(why_not_valid(solid));
        CHECK_FALSE(why_not_valid(Solid()));
    }
}
