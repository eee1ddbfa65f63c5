#include <doctest/doctest.h>

#include <algorithm>

#include "topology/embedding/embedding.h"
#include "topology/embedding/ring_plane.h"
#include "topology/modeling/lamina.h"
#include "topology/modeling/primitives.h"

using namespace topology;

namespace {

Solid block()
{
    Solid solid;
    EulerOperator op(solid);
    add_block(op, {0, 0, 0}, {2, 3, 4});
    return solid;
}

bool has(const Solid& solid, EmbeddingFault fault)
{
    const auto found = embedding_faults(solid);
    return std::any_of(found.begin(), found.end(), [&](const EmbeddingFinding& each) { return each.fault == fault; });
}

VertexId at(const Solid& solid, const Point& p)
{
    for (const VertexId v : solid.vertices())
        if (solid.point(v) == p) return v;
    FAIL("no vertex there");
    return {};
}

} // namespace

TEST_SUITE("embedding")
{
    TEST_CASE("A ring out of the plane of its face is told by its farthest vertex, one that lies in it is not")
    {
        class Last : public Observer {
        public:
            void changed(const Change& change) override { last = change; }
            Change last;
        } seen;
        Solid solid;
        EulerOperator op(solid);
        op.observe(seen);
        const auto base = op.mvfs({0, 0, 0});
        const auto far = op.mev(solid.half_edge(base.vertex), {4, 0, 0});
        const auto corner = op.mev(far.plus, {4, 3, 0});
        op.mef(corner.plus, solid.mate(far.plus));
        const FaceId f = base.face;
        op.mvr(f, {3, 1, 0});
        CHECK(!off_plane(solid, seen.last));
        const auto above = op.mvr(f, {3, 1, 0.5});
        REQUIRE(off_plane(solid, seen.last));
        CHECK(off_plane(solid, seen.last)->vertex == above.vertex);
        CHECK(off_plane(solid, seen.last)->face == f);
    }

    TEST_CASE("Nothing is wrong with blocks, prisms, tori, the Platonic solids, through holes and voids")
    {
        Solid solid;
        EulerOperator op(solid);
        const Prism outer = add_block(op, {0, 0, 0}, {9, 9, 9});
        add_void(op, {6, 6, 6}, {2, 2, 2});
        const FaceId floor = sink_pocket(op, outer.top, {{1, 1, 9}, {3, 1, 9}, {3, 4, 9}, {1, 4, 9}}, {0, 0, -9});
        CHECK(has(solid, EmbeddingFault::VertexOnFace)); // a pocket whose floor touches the base
        open_pocket(op, floor, outer.base);
        CHECK(embedding_faults(solid).empty());
        Solid torus, prism;
        EulerOperator on_torus(torus), on_prism(prism);
        add_torus(on_torus, {.radius = 3.0, .tube = 1.0}, 7, 5);
        add_prism(on_prism, 5, 2.0, 3.0);
        CHECK(embedding_faults(torus).empty());
        CHECK(embedding_faults(prism).empty());
        for (int kind = 0; kind < 5; ++kind) CHECK(embedding_faults(platonic(static_cast<Platonic>(kind))).empty());
        CHECK(embedding_faults(Solid()).empty());
    }

    TEST_CASE("A vertex moved onto its neighbour leaves an edge without length, moved aside a face that is not plane")
    {
        Solid short_edge = block(), bent = block();
        EulerOperator(short_edge).move(at(short_edge, {2, 3, 4}), {2, 0, 4});
        EulerOperator(bent).move(at(bent, {2, 3, 4}), {2.5, 3.25, 4.75});
        CHECK(has(short_edge, EmbeddingFault::ZeroLengthEdge));
        CHECK(has(bent, EmbeddingFault::NotPlanar));
        CHECK_FALSE(has(bent, EmbeddingFault::ZeroLengthEdge));
    }

    TEST_CASE("A ring beside its face, and one that runs the wrong way, are told from each other")
    {
        const auto with_ring = [](const std::vector<Point>& points) {
            Solid solid;
            EulerOperator op(solid);
            const Prism made = add_block(op, {0, 0, 0}, {9, 9, 2});
            const HalfEdgeId first = op.mvr(made.top, points.front()).half_edge;
            const HalfEdgeId last = wire(op, first, {points.begin() + 1, points.end()});
            op.mef(first, last);
            return solid;
        };
        const std::vector<Point> inside{{1, 1, 2}, {5, 1, 2}, {5, 4, 2}};
        std::vector<Point> turned(inside.rbegin(), inside.rend());
        CHECK(embedding_faults(with_ring(inside)).empty());
        CHECK(has(with_ring(turned), EmbeddingFault::RingTurned));
        CHECK_FALSE(has(with_ring(turned), EmbeddingFault::RingOutside));
        CHECK(has(with_ring({{11, 1, 2}, {15, 1, 2}, {15, 4, 2}}), EmbeddingFault::RingOutside));
    }

    TEST_CASE("A polygon that crosses itself names the two edges")
    {
        Solid solid;
        EulerOperator op(solid);
        lamina(op, {{0, 0, 0}, {5, 0, 0}, {5, 4, 0}, {2, -1, 0}});
        const auto found = embedding_faults(solid);
        REQUIRE(has(solid, EmbeddingFault::EdgesMeet));
        const auto meeting = std::find_if(found.begin(), found.end(), [](const EmbeddingFinding& each) {
            return each.fault == EmbeddingFault::EdgesMeet;
        });
        CHECK(sentence(*meeting).find("of one face meet elsewhere than at a common end") != std::string::npos);
    }

    TEST_CASE("A spike that goes through the far side is seen, and one that ends on it too")
    {
        Solid through, onto;
        for (const double depth : {-3.0, -2.0}) {
            Solid& solid = depth == -3.0 ? through : onto;
            EulerOperator op(solid);
            const Prism made = add_block(op, {0, 0, 0}, {6, 6, 2});
            sink_pocket(op, made.top, {{1, 1, 2}, {4, 1, 2}, {4, 3, 2}}, {0, 0, depth});
        }
        CHECK(has(through, EmbeddingFault::EdgeThroughFace));
        CHECK_FALSE(has(through, EmbeddingFault::VertexOnFace));
        CHECK(has(onto, EmbeddingFault::VertexOnFace));
        CHECK_FALSE(has(onto, EmbeddingFault::EdgeThroughFace));
    }

    TEST_CASE("A void without a solid around it is inside out")
    {
        Solid solid;
        EulerOperator op(solid);
        add_void(op, {1, 1, 1}, {2, 3, 4});
        CHECK(embedding_faults(solid) ==
              std::vector<EmbeddingFinding>{{EmbeddingFault::InsideOut, {FaceId{0}, FaceId{0}}}});
        add_block(op, {0, 0, 0}, {9, 9, 9});
        CHECK(embedding_faults(solid).empty());
    }

    TEST_CASE("A face that is still a wire encloses no area")
    {
        Solid solid;
        EulerOperator op(solid);
        wire(op, op.mvfs({0, 0, 0}).half_edge, {{4, 0, 0}, {4, 5, 0}});
        CHECK(embedding_faults(solid) ==
              std::vector<EmbeddingFinding>{{EmbeddingFault::NoArea, {FaceId{0}, FaceId{0}}}});
    }
}
