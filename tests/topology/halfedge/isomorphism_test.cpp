#include <doctest/doctest.h>

#include <array>

#include "tests/topology/halfedge/random_walk.h"
#include "topology/halfedge/check/isomorphism.h"
#include "topology/modeling/construction.h"
#include "topology/modeling/lamina.h"
#include "topology/modeling/primitives.h"

using namespace topology;

namespace {

Solid block(const Vector& size)
{
    Solid solid;
    EulerOperator op(solid);
    add_block(op, {0, 0, 0}, size);
    return solid;
}

} // namespace

TEST_SUITE("likeness")
{
    TEST_CASE("A cube is like a block made by a sweep, but not at the same places")
    {
        CHECK(are_alike(platonic(Platonic::Cube), block({1, 2, 3})));
        CHECK_FALSE(are_alike(platonic(Platonic::Cube), block({1, 2, 3}), Isomorphism::Places));
        CHECK_FALSE(are_alike(platonic(Platonic::Cube), platonic(Platonic::Octahedron)));
    }

    TEST_CASE("A random solid is like the one that its construction makes, at the same places")
    {
        for (unsigned seed = 1; seed <= 60; ++seed) {
            CAPTURE(seed);
            RandomWalk walk(seed);
            for (int i = 0; i < 30; ++i) walk.step(1.5);
            CHECK(are_alike(walk.solid, construction(walk.solid).solid, Isomorphism::Places));
        }
    }

    TEST_CASE("Equal counts are not enough: a ring of one face is not a ring of its neighbour's")
    {
        Solid two_apart = block({1, 1, 1}), two_together = two_apart;
        EulerOperator apart(two_apart), together(two_together);
        const FaceId f{0}, g{1};
        apart.mvr(f, {0, 0, 0});
        apart.mvr(g, {0, 0, 0});
        together.mvr(f, {0, 0, 0});
        together.mvr(f, {0, 0, 0});
        CHECK_FALSE(are_alike(two_apart, two_together));
        Solid also_apart = block({1, 1, 1});
        EulerOperator also(also_apart);
        also.mvr(g, {0, 0, 0});
        also.mvr(f, {0, 0, 0});
        CHECK(are_alike(two_apart, also_apart));
    }

    TEST_CASE("A triangle with two struts of unlike length is not its mirror image, but is like itself turned")
    {
        const auto triangle = [](std::size_t long_corner, std::size_t short_corner) {
            Solid solid;
            EulerOperator op(solid);
            const Lamina made = lamina(op, {{0, 0, 0}, {5, 0, 0}, {0, 4, 0}});
            std::array<HalfEdgeId, 3> corners{made.first, solid.next(made.first), solid.prev(made.first)};
            op.mev(op.mev(corners[long_corner], {1, 1, 0}).plus, {2, 1, 0});
            op.mev(corners[short_corner], {1, 2, 0});
            return solid;
        };
        CHECK(are_alike(triangle(0, 1), triangle(1, 2)));
        CHECK(are_alike(triangle(0, 1), triangle(2, 0)));
        CHECK_FALSE(are_alike(triangle(0, 1), triangle(1, 0)));
    }
}
