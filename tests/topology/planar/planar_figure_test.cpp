#include <doctest/doctest.h>

#include "topology/modeling/lamina.h"
#include "topology/planar/planar_figure.h"

using namespace topology;

TEST_SUITE("planar figure")
{
    TEST_CASE("A lamina's front is the region inside, counter-clockwise, and its back is all around")
    {
        Solid solid;
        EulerOperator op(solid);
        const Lamina made = lamina(op, {{0, 0, 7}, {4, 0, 7}, {4, 3, 7}, {0, 3, 7}});
        const auto frame = plane_of(solid);
        REQUIRE(frame);
        const PlanarFigure figure(solid, *frame);
        CHECK(figure.area(made.front) == 12.0);
        CHECK(figure.area(made.back) == -12.0);
        CHECK(figure.unbounded() == made.back);
        CHECK(figure.face_at({1, 1}) == made.front);
        CHECK(figure.face_at({5, 1}) == made.back);
        CHECK(figure.corner(solid.start(made.first), {1, 1}) == made.first);
        CHECK(solid.face(figure.corner(solid.start(made.first), {-1, 1})) == made.back);
        CHECK(figure.area(made.first, solid.next(solid.next(made.first))) == 6.0);
    }

    TEST_CASE("A point in a ring of a face is not in the face")
    {
        Solid solid;
        EulerOperator op(solid);
        const Lamina outer = lamina(op, {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}});
        const HalfEdgeId corner = op.mvr(outer.front, {3, 3, 0}).half_edge;
        const HalfEdgeId last = wire(op, corner, {{6, 3, 0}, {6, 6, 0}});
        const FaceId inner = op.mef(corner, last).face;
        const Frame frame = *plane_of(solid);
        const PlanarFigure figure(solid, frame);
        CHECK(figure.face_at({5, 4}) == inner);
        CHECK(figure.face_at({1, 8}) == outer.front);
        CHECK(figure.area(outer.front) == 81.0 - 4.5);
    }

    TEST_CASE("A block lies in no plane, an upright lamina in its own, a wire in a level one")
    {
        Solid block, upright, lone;
        EulerOperator on_block(block), on_upright(upright), on_lone(lone);
        wire(on_block, on_block.mvfs({0, 0, 0}).half_edge, {{2, 0, 0}, {0, 3, 0}, {0, 0, 5}});
        CHECK_FALSE(plane_of(block));
        lamina(on_upright, {{0, 2, 0}, {3, 2, 0}, {3, 2, 5}});
        REQUIRE(plane_of(upright));
        CHECK(plane_of(upright)->normal() == Vector{0, 1, 0});
        on_lone.mev(on_lone.mvfs({1, 2, 3}).half_edge, {4, 6, 3});
        REQUIRE(plane_of(lone));
        CHECK(plane_of(lone)->normal().z == doctest::Approx(1.0));
        CHECK_FALSE(plane_of(Solid()));
    }
}
