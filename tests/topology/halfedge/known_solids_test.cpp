// Solids whose counts stand in the literature, and the sentences of refusals.
#include <doctest/doctest.h>

#include <array>
#include <vector>

#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"
#include "topology/halfedge/operators/euler_operator.h"

using namespace topology;

namespace {

/// An n-sided prism by MVFS, n - 1 struts, MEF, then struts up and MEF for each side. \returns its bottom and top faces
std::array<FaceId, 2> add_prism(EulerOperator& op, int n, double z, double height)
{
    const auto point = [&](int i, double level) { return Point{1.0 * i, 0.5 * i * i, level}; };
    const LoneVertex first = op.mvfs(point(0, z));
    HalfEdgeId corner = first.half_edge;
    for (int i = 1; i < n; ++i) corner = op.mev(corner, point(i, z)).plus;
    const NewFace lid = op.mef(first.half_edge, corner);
    // The old face is swept up, from the half-edge that starts at the first vertex on.
    HalfEdgeId scan = lid.plus;
    const HalfEdgeId first_up = op.mev(scan, point(0, z + height)).plus;
    HalfEdgeId left = first_up;
    scan = op.solid().next(scan);
    for (int i = 1; i < n; ++i) {
        const HalfEdgeId next = op.solid().next(scan);
        const HalfEdgeId up = op.mev(scan, point(i, z + height)).plus;
        left = op.mef(left, up).plus;
        scan = next;
    }
    op.mef(op.solid().next(left), op.solid().next(op.solid().next(op.solid().next(op.solid().next(left)))));
    return {lid.face, first.face};
}

EulerCounts counts_of(const Solid& solid)
{
    CHECK_NOTHROW(validate(solid));
    const EulerCounts counts = euler_counts(solid);
    CHECK(counts.formula() == 0);
    return counts;
}

} // namespace

TEST_SUITE("known solids")
{
    TEST_CASE("MVFS makes the skeletal solid of one vertex, face, loop and shell")
    {
        Solid solid;
        EulerOperator(solid).mvfs({1, 2, 3});
        CHECK(counts_of(solid) == EulerCounts{.V = 1, .E = 0, .F = 1, .L = 1, .S = 1, .G = 0});
    }

    TEST_CASE("A tetrahedron takes MVFS, three MEV and three MEF")
    {
        Solid solid;
        Journal journal;
        EulerOperator op(solid, journal);
        const HalfEdgeId a = op.mvfs({0, 0, 0}).half_edge;
        const HalfEdgeId b = op.mev(a, {1, 0, 0}).plus;
        const HalfEdgeId c = op.mev(b, {0, 1, 0}).plus;
        op.mef(a, c);
        const HalfEdgeId apex = op.mev(c, {0, 0, 1}).plus;
        op.mef(apex, solid.next(solid.next(apex)));
        op.mef(solid.prev(solid.mate(apex)), solid.next(solid.mate(apex)));
        CHECK(journal.n_done() == 7);
        CHECK(counts_of(solid) == EulerCounts{.V = 4, .E = 6, .F = 4, .L = 4, .S = 1, .G = 0});
        for (const LoopId l : solid.loops()) {
            int length = 0;
            for ([[maybe_unused]] const HalfEdgeId h : solid.chain(l)) ++length;
            CHECK(length == 3);
        }
    }

    TEST_CASE("The torus of one vertex: MVFS, MEF of a corner with itself, KFMRH, MEKR; again for each further handle")
    {
        Solid solid;
        EulerOperator op(solid);
        const FaceId f = op.mvfs({0, 0, 0}).face;
        for (std::size_t genus = 1; genus <= 5; ++genus) {
            const HalfEdgeId h = solid.half_edge(solid.outer(f));
            const NewFace lid = op.mef(h, h);
            op.kfmrh(f, lid.face);
            op.mekr(solid.half_edge(solid.outer(f)), lid.minus);
            CHECK(counts_of(solid) == EulerCounts{.V = 1, .E = 2 * genus, .F = 1, .L = 1, .S = 1, .G = genus});
        }
    }

    TEST_CASE("KFMRH of two shells joins them, of one makes a handle, and MFKRH takes both back")
    {
        Solid solid;
        EulerOperator op(solid);
        const auto lower = add_prism(op, 4, 0, 1), upper = add_prism(op, 4, 2, 1);
        CHECK(counts_of(solid) == EulerCounts{.V = 16, .E = 24, .F = 12, .L = 12, .S = 2, .G = 0});
        const LoopId joint = solid.outer(upper[0]), handle = solid.outer(upper[1]);
        op.kfmrh(lower[1], upper[0]);
        CHECK(counts_of(solid) == EulerCounts{.V = 16, .E = 24, .F = 11, .L = 12, .S = 1, .G = 0});
        op.kfmrh(lower[0], upper[1]);
        CHECK(counts_of(solid) == EulerCounts{.V = 16, .E = 24, .F = 10, .L = 12, .S = 1, .G = 1});
        op.mfkrh(handle);
        CHECK(counts_of(solid).G == 0);
        op.mfkrh(joint);
        CHECK(counts_of(solid).S == 2);
    }

    TEST_CASE("Hoffmann's figure: 24 vertices, 36 edges, 16 faces, 18 loops, 2 shells, genus sum 1")
    {
        Solid solid;
        EulerOperator op(solid);
        add_prism(op, 4, 1, 1); // the void
        const auto block = add_prism(op, 4, 0, 3), hole = add_prism(op, 4, 0, 3);
        op.kfmrh(block[0], hole[0]);
        op.kfmrh(block[1], hole[1]);
        CHECK(counts_of(solid) == EulerCounts{.V = 24, .E = 36, .F = 16, .L = 18, .S = 2, .G = 1});
        const auto parts = shells(solid);
        REQUIRE(parts.size() == 2);
        CHECK(parts[0].genus == 0);
        CHECK(parts[1].genus == 1);
        CHECK(parts[1].counts == Counts{.vertices = 16, .edges = 24, .half_edges = 48, .faces = 10, .loops = 12});
    }
}

TEST_SUITE("known solids")
{
    TEST_CASE("A ring does not move to a part that it alone connects with its face")
    {
        Solid solid;
        EulerOperator op(solid);
        const auto block = add_prism(op, 4, 0, 1), boss = add_prism(op, 5, 1, 1), other = add_prism(op, 3, 9, 1);
        op.kfmrh(block[1], boss[0]);
        const LoopId ring = *++solid.loops(block[1]).begin();
        const auto reason = op.why_not_ringmv(ring, boss[1]);
        REQUIRE(reason);
        CHECK(sentence(*reason) == "nothing but the ring l8 connects f1 with f7; it cannot move there");
        CHECK(op.why_not_ringmv(ring, other[1])->kind == RefusalKind::NotConnected);
        const EulerCounts before = counts_of(solid);
        CHECK_FALSE(op.why_not_ringmv(ring, block[0]));
        op.ringmv(ring, block[0]);
        CHECK(counts_of(solid) == before);
        CHECK(solid.face(ring) == block[0]);
    }

    TEST_CASE("A refusal names the parts and a remedy")
    {
        Solid solid;
        EulerOperator op(solid);
        const LoneVertex lone = op.mvfs({0, 0, 0});
        CHECK(sentence(*op.why_not_kev(lone.half_edge)) ==
              "v1 is a lone vertex without an edge; make one with MEV first");
        const NewEdge edge = op.mev(lone.half_edge, {1, 0, 0});
        CHECK(sentence(*op.why_not_mev(edge.plus, edge.minus)) ==
              "he2 starts at v2 and he1 does not; give two half-edges that start at one vertex");
        CHECK(sentence(*op.why_not_kef(edge.plus)) == "both sides of e1 lie in face f1; kill it with KEV or KEMR");
        CHECK(sentence(*op.why_not_kvfs(lone.face)) ==
              "f1 is more than a lone vertex; take its edges and rings away first");
        CHECK(sentence(*op.why_not_kvr(lone.loop)) == "l1 is the outer loop of face f1; a ring is needed");
        CHECK(sentence(*op.why_not_kev(HalfEdgeId{8})) == "there is no he9; it was killed or never made");
        CHECK(sentence(*op.why_not_mev(edge.plus, edge.minus), [](Entity) { return std::string("it"); }) ==
              "it starts at it and it does not; give two half-edges that start at one vertex");
    }
}
