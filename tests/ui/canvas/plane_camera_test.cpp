#include "ui/canvas/plane_camera.h"

#include <doctest/doctest.h>

#include <array>
#include <limits>
#include <random>

using doctest::Approx;

TEST_SUITE_BEGIN("cameras");

TEST_CASE("A model of any size is fitted, far smaller than an atom and far larger than a galaxy")
{
    for (const double size : {1e-60, 1e-11, 1.0, 1e12, 1e60}) {
        CAPTURE(size);
        ui::PlaneCamera camera;
        const std::array<ui::World2, 2> ends{{{0.0, 0.0}, {size, size}}};
        camera.fit(ends, {800.0, 600.0}); // margins of 40
        CHECK(camera.to_sheet(ends[1]).x - camera.to_sheet(ends[0]).x == doctest::Approx(520.0));
    }
}

TEST_CASE("y is up in the world and down on the sheet")
{
    const ui::PlaneCamera camera({70.0, 300.0}, 25.0);
    CHECK(camera.to_sheet({2.0, 3.0}) == ui::Point{70.0 + 2.0 * 25.0, 300.0 - 3.0 * 25.0});
}

TEST_CASE("From the world to the sheet and back is where one was")
{
    const ui::PlaneCamera camera({70.0, 300.0}, 25.0);
    const ui::World2 back = camera.to_world(camera.to_sheet({-1.75, 3.5}));
    CHECK(back.x == Approx(-1.75));
    CHECK(back.y == Approx(3.5));
}

TEST_CASE("Through a hundred zooms the place under the cursor stays within half a pixel")
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> x(0.0, 1280.0), y(0.0, 800.0), power(-0.7, 0.7);
    ui::PlaneCamera camera({640.0, 700.0}, 90.0);
    for (int i = 0; i < 100; ++i) {
        const double at_x = x(random);
        const ui::Point cursor{at_x, y(random)};
        const ui::World2 under = camera.to_world(cursor);
        camera.zoom(cursor, std::exp(power(random)));
        CHECK(ui::distance(camera.to_sheet(under), cursor) < 0.5);
    }
}

TEST_CASE("At the end of the range of scales the cursor still stays over its place")
{
    ui::PlaneCamera camera({0.0, 0.0}, ui::PlaneCamera::largest_scale / 2.0);
    const ui::Point cursor{3.0, 4.0};
    const ui::World2 under = camera.to_world(cursor);
    camera.zoom(cursor, 1000.0);
    CHECK(camera.scale() == ui::PlaneCamera::largest_scale);
    CHECK(ui::distance(camera.to_sheet(under), cursor) < 0.5);
}

TEST_CASE("A zoom that is not a positive number changes nothing")
{
    const ui::PlaneCamera before({70.0, 300.0}, 25.0);
    for (const double factor :
         {0.0, -2.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        ui::PlaneCamera camera = before;
        camera.zoom({10.0, 10.0}, factor);
        CHECK(camera == before);
    }
}

TEST_CASE("A fitted model touches the margins of the tighter direction and is centred in the other")
{
    ui::PlaneCamera camera;
    const std::vector<ui::World2> portal = {{1.0, 2.0}, {1.0, 6.0}, {9.0, 6.0}, {9.0, 2.0}}; // 8 wide, 4 high
    camera.fit(portal, {1000.0, 700.0}, {.left = 50.0, .top = 30.0, .right = 150.0, .bottom = 70.0});
    CHECK(camera.scale() == Approx(800.0 / 8.0)); // 600 / 4 would be more
    CHECK(camera.to_sheet({1.0, 2.0}).x == Approx(50.0));
    CHECK(camera.to_sheet({9.0, 2.0}).x == Approx(850.0));
    const double above = camera.to_sheet({1.0, 6.0}).y - 30.0, below = 630.0 - camera.to_sheet({1.0, 2.0}).y;
    CHECK(above == Approx(below));
}

TEST_CASE("A level beam fits by its length and a single node keeps the scale")
{
    ui::PlaneCamera camera({0.0, 0.0}, 33.0);
    camera.fit(std::vector<ui::World2>{{4.0, 5.0}}, {400.0, 200.0});
    CHECK(camera.scale() == 33.0);
    CHECK(camera.to_sheet({4.0, 5.0}) == ui::Point{200.0, 100.0});
    camera.fit(std::vector<ui::World2>{{0.0, 5.0}, {8.0, 5.0}}, {400.0, 200.0});
    CHECK(camera.scale() == Approx(320.0 / 8.0));
}

TEST_CASE("Fitting nothing, or to nothing, changes nothing")
{
    const ui::PlaneCamera before({70.0, 300.0}, 25.0);
    ui::PlaneCamera camera = before;
    camera.fit({}, {400.0, 200.0});
    CHECK(camera == before);
    camera.fit(std::vector<ui::World2>{{0.0, 0.0}, {1.0, 1.0}}, {0.0, 0.0});
    CHECK(camera == before);
    camera.fit(std::vector<ui::World2>{{std::nan(""), 0.0}}, {400.0, 200.0});
    CHECK(camera == before);
}

TEST_CASE("A pan moves every place by the same pixels")
{
    ui::PlaneCamera camera({70.0, 300.0}, 25.0);
    const ui::Point before = camera.to_sheet({2.0, 3.0});
    camera.pan({13.0, -7.0});
    CHECK(camera.to_sheet({2.0, 3.0}) == before + ui::Point{13.0, -7.0});
}

TEST_SUITE_END();
