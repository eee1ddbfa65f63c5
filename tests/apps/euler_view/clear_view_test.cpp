#include "apps/euler/view/solid/clear_view.h"

#include "apps/euler/view/shapes/outline.h"
#include "tests/apps/euler_view/example_solids.h"
#include "topology/modeling/primitives.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <vector>

using namespace euler;

namespace {

/// How near two vertices or a vertex and an edge that is not its own are seen, as a share of what is seen.
double nearest(const topology::Solid& solid, ui::OrbitCamera camera)
{
    std::vector<ui::World3> places;
    for (const topology::VertexId v : solid.vertices()) {
        const topology::Point& p = solid.point(v);
        places.push_back({p.x, p.y, p.z});
    }
    camera.fit(places, {1000.0, 1000.0});
    const auto seen = [&](topology::VertexId v) {
        const topology::Point& p = solid.point(v);
        return camera.to_sheet({p.x, p.y, p.z});
    };
    double least = std::numeric_limits<double>::infinity();
    for (const topology::VertexId v : solid.vertices()) {
        for (const topology::VertexId w : solid.vertices())
            if (w < v) least = std::min(least, ui::distance(seen(v), seen(w)));
        for (const topology::EdgeId e : solid.edges()) {
            const auto a = solid.start(solid.plus(e)), b = solid.end(solid.plus(e));
            if (a != v && b != v) least = std::min(least, distance_to_segment(seen(v), seen(a), seen(b)));
        }
    }
    return least / 1000.0;
}

ui::OrbitCamera looking(double azimuth, double elevation)
{
    ui::OrbitCamera camera;
    camera.look(azimuth, elevation);
    return camera;
}

} // namespace

TEST_SUITE("euler view")
{
    TEST_CASE("From a corner no vertex of a block or a tetrahedron covers another or lies on an edge of others")
    {
        topology::Solid block;
        topology::EulerOperator op(block);
        topology::add_block(op, {0, 0, 0}, {2, 2, 2});
        const std::vector<Subject> subjects{{&block, nullptr, {}}};
        const ui::OrbitCamera corner; // along the diagonal, so that two corners are one
        CHECK(nearest(block, corner) < 1e-9);
        CHECK(nearest(block, clear_view(corner, subjects)) > 0.04);

        const view_test::Made tetrahedron(view_test::example("tetrahedron"));
        const ui::OrbitCamera edge_on = looking(-1.1, 0.42);
        CHECK(nearest(tetrahedron.solid(), edge_on) < 0.02);
        CHECK(nearest(tetrahedron.solid(), clear_view(edge_on, tetrahedron.subjects())) > 0.04);
    }

    TEST_CASE("However a solid stands, its clear view shows every vertex apart")
    {
        for (const double turn : {0.0, 0.4, 0.9, 1.3}) {
            for (const char* name : {"cube", "tetrahedron", "void", "through_hole"}) {
                CAPTURE(name);
                CAPTURE(turn);
                const view_test::Made made(view_test::example(name));
                CHECK(nearest(made.solid(), clear_view(looking(turn, 0.42), made.subjects())) > 0.005);
            }
        }
    }

    TEST_CASE("A view that is clear stays as it is, and one of a single vertex")
    {
        const view_test::Made cube(view_test::example("cube"));
        const ui::OrbitCamera clear = looking(-1.1, 0.42);
        CHECK(clear_view(clear, cube.subjects()) == clear);
        const view_test::Made point("mvfs s1 f1 v1 0 0 0");
        CHECK(clear_view(clear, point.subjects()) == clear);
    }
}
