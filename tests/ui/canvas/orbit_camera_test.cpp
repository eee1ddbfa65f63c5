#include "ui/canvas/orbit_camera.h"

#include <doctest/doctest.h>
#include <vector>

#include <cmath>
#include <numbers>

using doctest::Approx;

namespace {

/// How a unit vector of the world appears on the sheet, y up.
ui::Point seen(const ui::OrbitCamera& camera, ui::World3 axis)
{
    const ui::Point d = camera.to_sheet(axis) - camera.to_sheet({});
    return ui::Point{d.x, -d.y} / camera.scale();
}

void check_seen(const ui::OrbitCamera& camera, ui::World3 axis, ui::Point expected)
{
    CHECK(ui::distance(seen(camera, axis), expected) < 1e-12);
}

} // namespace

TEST_SUITE_BEGIN("cameras");

TEST_CASE("The isometric view shortens the three axes to the square root of two thirds, 120 degrees apart")
{
    const ui::OrbitCamera camera;
    const double r = std::sqrt(2.0 / 3.0), c = std::cos(std::numbers::pi / 6.0), s = 0.5;
    check_seen(camera, {1.0, 0.0, 0.0}, {r * c, -r * s});
    check_seen(camera, {0.0, 1.0, 0.0}, {r * c, r * s});
    check_seen(camera, {0.0, 0.0, 1.0}, {0.0, r});
}

TEST_CASE("Front shows x and z, side y and z, top x and y, in true length")
{
    ui::OrbitCamera camera;
    camera.look(ui::StandardView::Front);
    check_seen(camera, {1.0, 0.0, 0.0}, {1.0, 0.0});
    check_seen(camera, {0.0, 1.0, 0.0}, {0.0, 0.0});
    check_seen(camera, {0.0, 0.0, 1.0}, {0.0, 1.0});
    camera.look(ui::StandardView::Side);
    check_seen(camera, {1.0, 0.0, 0.0}, {0.0, 0.0});
    check_seen(camera, {0.0, 1.0, 0.0}, {1.0, 0.0});
    camera.look(ui::StandardView::Top);
    check_seen(camera, {1.0, 0.0, 0.0}, {1.0, 0.0});
    check_seen(camera, {0.0, 1.0, 0.0}, {0.0, 1.0});
    check_seen(camera, {0.0, 0.0, 1.0}, {0.0, 0.0});
}

TEST_CASE("While orbiting the pivot stays within half a pixel, and the eye stops at the pole")
{
    ui::OrbitCamera camera;
    const ui::World3 pivot{3.0, -2.0, 5.5};
    const ui::Point before = camera.to_sheet(pivot);
    for (int i = 0; i < 50; ++i) camera.orbit({17.0, 29.0}, pivot);
    CHECK(ui::distance(camera.to_sheet(pivot), before) < 0.5);
    CHECK(camera.elevation() == Approx(std::numbers::pi / 2.0));
}

TEST_CASE("Dragging to the right turns what is in front to the right")
{
    ui::OrbitCamera camera;
    camera.look(ui::StandardView::Front);
    const ui::World3 in_front{0.0, -1.0, 0.0}; // towards the eye
    REQUIRE(camera.nearness(in_front) > camera.nearness({}));
    camera.orbit({40.0, 0.0}, {});
    CHECK(camera.to_sheet(in_front).x > camera.to_sheet({}).x);
}

TEST_CASE("A place goes to the sheet and back, given how near it is")
{
    ui::OrbitCamera camera;
    camera.look(0.4, 0.9);
    const ui::World3 place{3.0, -2.0, 5.5};
    const ui::World3 back = camera.to_world(camera.to_sheet(place), camera.nearness(place));
    CHECK(back.x == Approx(place.x));
    CHECK(back.y == Approx(place.y));
    CHECK(back.z == Approx(place.z));
}

TEST_CASE("A fitted space frame lies within the margins and touches two of them")
{
    ui::OrbitCamera camera;
    std::vector<ui::World3> corners;
    for (const double x : {0.0, 6.0})
        for (const double y : {0.0, 4.0})
            for (const double z : {0.0, 3.0}) corners.push_back({x, y, z});
    camera.fit(corners, {900.0, 700.0}, {.left = 50.0, .top = 50.0, .right = 50.0, .bottom = 50.0});
    ui::Box box{camera.to_sheet(corners[0]), camera.to_sheet(corners[0])};
    for (const ui::World3 c : corners) box = ui::united(box, {camera.to_sheet(c), camera.to_sheet(c)});
    CHECK(ui::Box{{50.0, 50.0}, {850.0, 650.0}}.grown(1e-6).contains(box));
    CHECK(std::max(box.width() / 800.0, box.height() / 600.0) == Approx(1.0));
}

TEST_SUITE_END();
