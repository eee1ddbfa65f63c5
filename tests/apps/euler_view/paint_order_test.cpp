#include "apps/euler/view/shapes/outline.h"
#include "apps/euler/view/solid/paint_order.h"
#include "apps/euler/view/solid/solid_shapes.h"
#include "tests/apps/euler_view/example_solids.h"
#include "topology/modeling/mass_properties.h"

#include <doctest/doctest.h>

#include <limits>
#include <random>

using namespace euler;
using view_test::example;
using view_test::Made;

TEST_SUITE_BEGIN("euler view: order of painting");

namespace {

constexpr ui::Size overlap_sheet{640.0, 480.0};

/// Depth [px] of a face's plane at a place of the sheet.
double depth(const topology::Solid& solid, topology::FaceId f, ui::Point at, const ui::OrbitCamera& camera)
{
    const ViewTransform transform(camera);
    const topology::Point& corner = solid.point(solid.start(solid.half_edge(solid.outer(f))));
    const auto plane = depth_plane(corner, topology::area_vector(solid, f), transform);
    return plane ? (*plane)(at) : std::numeric_limits<double>::quiet_NaN();
}

/// How many times a piece painted later lies behind one painted before, at random places of the sheet.
int n_wrong(const Made& made, const ui::OrbitCamera& camera, std::mt19937& random)
{
    const Shapes shapes = solid_shapes(made.subjects(), camera, {});
    std::uniform_real_distribution<double> x(0.0, overlap_sheet.width), y(0.0, overlap_sheet.height);
    int wrong = 0;
    for (int i = 0; i < 400; ++i) {
        const ui::Point at{x(random), y(random)};
        double before = -std::numeric_limits<double>::infinity();
        for (const Shapes::Piece& piece : shapes.pieces) {
            if (!is_inside(piece.area, at)) continue;
            const double now = depth(made.solid(), shapes.faces[piece.face].face, at, camera);
            if (now < before - 0.1) ++wrong;
            if (now > before) before = now;
        }
    }
    return wrong;
}

} // namespace

TEST_CASE("From every side, of faces that cover a place the one in front is painted last, rings and voids included")
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> azimuth(-3.1, 3.1), elevation(-1.5, 1.5);
    for (const char* name : {"cube", "tetrahedron", "through_hole", "hoffmann", "void"}) {
        const Made made(example(name));
        for (int i = 0; i < 12; ++i) {
            ui::OrbitCamera camera;
            camera.look(azimuth(random), elevation(random));
            camera = fitted(camera, made.subjects(), {}, overlap_sheet);
            CAPTURE(name);
            CAPTURE(camera.azimuth());
            CAPTURE(camera.elevation());
            CHECK(n_wrong(made, camera, random) == 0);
        }
    }
}

TEST_CASE("Nothing is painted in a face's hole")
{
    const Made made(example("through_hole"));
    ui::OrbitCamera camera;
    camera.look(ui::StandardView::Top);
    camera = fitted(camera, made.subjects(), {}, overlap_sheet);
    const Shapes shapes = solid_shapes(made.subjects(), camera, {});
    const ui::Point in_hole = camera.to_sheet({2.0, 2.0, 2.0}), beside = camera.to_sheet({0.5, 3.1, 2.0});
    const auto n_at = [&](ui::Point at) {
        return std::count_if(shapes.pieces.begin(), shapes.pieces.end(),
                             [&](const Shapes::Piece& piece) { return is_inside(piece.area, at); });
    };
    CHECK(n_at(in_hole) == 0);
    CHECK(n_at(beside) == 2); // the top and the bottom
}

TEST_CASE("A face seen from inside is painted before the one on the other side of a thin solid")
{
    const Made lamina(example("cube", 5));
    ui::OrbitCamera camera;
    camera.look(ui::StandardView::Top);
    const Shapes shapes = solid_shapes(lamina.subjects(), fitted(camera, lamina.subjects(), {}, overlap_sheet), {});
    REQUIRE(shapes.pieces.size() == 2);
    CHECK(shapes.pieces[0].is_back);
    CHECK_FALSE(shapes.pieces[1].is_back);
}

TEST_SUITE_END();
