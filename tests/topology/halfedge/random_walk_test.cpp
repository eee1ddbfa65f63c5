#include <doctest/doctest.h>

#include <vector>

#include "tests/topology/halfedge/random_walk.h"
#include "topology/halfedge/check/shells.h"
#include "topology/halfedge/check/validate.h"
#include "topology/halfedge/renumbering.h"

using namespace topology;

TEST_SUITE("random walks")
{
    TEST_CASE("100 000 operators at random keep the solid sound, and all of them can be undone and redone")
    {
        constexpr int n_steps = 100000, stride = 1000;
        RandomWalk walk(20260401);
        std::vector<Solid> milestones;
        for (int i = 0; i < n_steps; ++i) {
            if (i % stride == 0) {
                milestones.push_back(walk.solid);
                validate(walk.solid);
                REQUIRE(euler_counts(walk.solid).formula() == 0);
            }
            walk.step(1.3);
        }
        const Solid last = walk.solid;
        REQUIRE(walk.journal.n_done() == n_steps);
        CHECK(euler_counts(last).G > 3);
        CHECK(euler_counts(last).L > euler_counts(last).F);
        for (int i = n_steps; i > 0; --i) {
            walk.op().undo();
            if ((i - 1) % stride == 0) REQUIRE(walk.solid == milestones[static_cast<std::size_t>((i - 1) / stride)]);
        }
        CHECK(walk.solid == Solid());
        for (int i = 0; i < n_steps; ++i) walk.op().redo();
        CHECK(walk.solid == last);
    }

    TEST_CASE("Many short walks are sound at every step")
    {
        for (std::uint32_t seed = 100; seed < 300; ++seed) {
            CAPTURE(seed);
            RandomWalk walk(seed);
            for (int i = 0; i < 150; ++i) {
                CAPTURE(i);
                const OperatorKind kind = walk.step(seed % 2 == 0 ? 1.0 : 1.6);
                CAPTURE(name(kind));
                const auto breach = why_not_valid(walk.solid);
                REQUIRE_MESSAGE(!breach, (breach ? sentence(*breach) : ""));
                REQUIRE(euler_counts(walk.solid).formula() == 0);
            }
        }
    }

    TEST_CASE("A compact solid has no dead, the same counts, and is the same solid under other numbers")
    {
        for (std::uint32_t seed = 1; seed < 20; ++seed) {
            CAPTURE(seed);
            RandomWalk walk(seed);
            for (int i = 0; i < 200; ++i) walk.step();
            const Renumbering renumbering(walk.solid);
            const Solid& small = renumbering.compact();
            CHECK(small.counts() == walk.solid.counts());
            CHECK(small.half_edges().n_rows() == small.counts().half_edges);
            CHECK_NOTHROW(validate(small));
            CHECK(euler_counts(small) == euler_counts(walk.solid));
            for (const HalfEdgeId h : walk.solid.half_edges()) {
                REQUIRE(small.next(*renumbering.of(h)) == *renumbering.of(walk.solid.next(h)));
                REQUIRE(small.point(small.start(*renumbering.of(h))) == walk.solid.point(walk.solid.start(h)));
            }
            for (const FaceId f : walk.solid.faces())
                CHECK(small.outer(*renumbering.of(f)) == *renumbering.of(walk.solid.outer(f)));
            CHECK(compact(small) == small);
        }
    }
}
