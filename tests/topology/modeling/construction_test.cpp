#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "tests/topology/halfedge/random_walk.h"
#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"
#include "topology/modeling/construction.h"

using namespace topology;

namespace {

/// The loops of a solid as lists of points, each from its least rotation on, sorted; points are told apart by chance.
std::vector<std::vector<std::array<double, 3>>> outline(const Solid& solid)
{
    std::vector<std::vector<std::array<double, 3>>> loops;
    for (const LoopId l : solid.loops()) {
        std::vector<std::array<double, 3>> points;
        for (const HalfEdgeId h : solid.chain(l)) {
            const Point& p = solid.point(solid.start(h));
            points.push_back({p.x, p.y, p.z});
        }
        std::vector<std::array<double, 3>> least = points;
        for (std::size_t i = 0; i < points.size(); ++i) {
            std::rotate(points.begin(), points.begin() + 1, points.end());
            least = std::min(least, points);
        }
        least.push_back({solid.is_outer(l) ? 1.0 : 0.0, 0.0, 0.0});
        loops.push_back(least);
    }
    std::sort(loops.begin(), loops.end());
    return loops;
}

} // namespace

TEST_SUITE("construction")
{
    TEST_CASE("Every solid can be made from nothing, with the numbers of operators that the theory asks for")
    {
        std::size_t greatest_genus = 0;
        for (std::uint32_t seed = 1; seed <= 200; ++seed) {
            CAPTURE(seed);
            RandomWalk walk(seed);
            for (std::uint32_t i = 0; i < 40 + seed; ++i) walk.step(1.7);
            const Construction made = construction(walk.solid);
            REQUIRE_NOTHROW(validate(made.solid));
            const EulerCounts counts = euler_counts(walk.solid);
            CHECK(euler_counts(made.solid) == counts);
            CHECK(outline(made.solid) == outline(walk.solid));
            std::map<OperatorKind, std::size_t> n;
            for (std::size_t i = 0; i < made.journal.n_done(); ++i) ++n[made.journal[i].kind];
            const std::size_t n_rings = counts.L - counts.F;
            CHECK(n[OperatorKind::MVFS] == counts.S);
            CHECK(n[OperatorKind::MEV] == counts.V - counts.S);
            CHECK(n[OperatorKind::MEF] == counts.F + counts.G - counts.S);
            CHECK(n[OperatorKind::KFMRH] == counts.G);
            CHECK(n[OperatorKind::KEMR] + counts.G == n_rings + n[OperatorKind::MEKR]);
            greatest_genus = std::max(greatest_genus, counts.G);
        }
        CHECK(greatest_genus > 3);
    }

    TEST_CASE("Names of vertices and faces follow from the original to what is made")
    {
        RandomWalk walk(11);
        for (int i = 0; i < 120; ++i) walk.step(1.7);
        const Construction made = construction(walk.solid);
        REQUIRE(made.vertex_of.size() == made.solid.vertices().n_rows());
        REQUIRE(made.face_of.size() == made.solid.faces().n_rows());
        for (const VertexId v : made.solid.vertices())
            CHECK(made.solid.point(v) == walk.solid.point(made.vertex_of[v.index]));
        for (const FaceId f : made.solid.faces()) CHECK(walk.solid.has(made.face_of[f.index]));
    }
}
