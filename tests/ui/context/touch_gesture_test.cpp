#include "ui/context/touch_gesture.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <vector>

TEST_SUITE_BEGIN("touch gesture");

using ui::Point;
using ui::PointerButton;

namespace {

bool holds(const ui::Input& input, ui::PointerButton button)
{
    return input.is_button_down[static_cast<std::size_t>(button)];
}

/// Fingers on a screen, and the frames that a program sees of them.
struct Screen {
    ui::TouchGesture gesture;
    ui::ButtonEvents buttons;
    ui::Input input;

    void touch(const std::vector<Point>& fingers, double time) { gesture.follow(fingers, time, buttons, input); }
    ui::Input frame()
    {
        ui::Input current = input;
        buttons.deliver_next(current);
        input.wheel = {};
        return current;
    }
};

} // namespace

TEST_CASE("A tap is a click where it was, and a finger that has only come down is none yet")
{
    Screen screen;
    screen.touch({{30.0, 70.0}}, 1.0);
    CHECK(!holds(screen.frame(), PointerButton::Left));
    screen.touch({{33.0, 68.0}}, 1.1);
    screen.touch({}, 1.2);
    const ui::Input down = screen.frame(), up = screen.frame();
    CHECK(holds(down, PointerButton::Left));
    CHECK(*down.pointer == Point{30.0, 70.0});
    CHECK(!holds(up, PointerButton::Left));
}

TEST_CASE("A finger that moves drags from where it came down to where it leaves")
{
    Screen screen;
    screen.touch({{30.0, 70.0}}, 1.0);
    screen.touch({{50.0, 70.0}}, 1.1);
    const ui::Input down = screen.frame();
    CHECK(holds(down, PointerButton::Left));
    CHECK(*down.pointer == Point{30.0, 70.0});
    CHECK(*screen.frame().pointer == Point{50.0, 70.0});
    screen.touch({{90.0, 75.0}}, 5.0);
    CHECK(!screen.gesture.tick(6.0, screen.buttons)); // a drag takes as long as it takes
    CHECK(holds(screen.frame(), PointerButton::Left));
    screen.touch({}, 6.1);
    const ui::Input up = screen.frame();
    CHECK(!holds(up, PointerButton::Left));
    CHECK(*up.pointer == Point{90.0, 75.0});
}

TEST_CASE("A finger that rests is a click of the right button, and its end is no click of the left one")
{
    Screen screen;
    screen.touch({{30.0, 70.0}}, 1.0);
    CHECK(!screen.gesture.tick(1.5, screen.buttons));
    CHECK(screen.gesture.tick(1.7, screen.buttons));
    CHECK(!screen.gesture.tick(1.8, screen.buttons));
    CHECK(holds(screen.frame(), PointerButton::Right));
    CHECK(!holds(screen.frame(), PointerButton::Right));
    screen.touch({{60.0, 70.0}}, 1.9);
    screen.touch({}, 2.0);
    for (int i = 0; i < 3; ++i) CHECK(!holds(screen.frame(), PointerButton::Left));
}

TEST_CASE("Two fingers move the view with the middle button, and what is between them comes along")
{
    Screen screen;
    screen.touch({{30.0, 70.0}}, 1.0);
    screen.touch({{30.0, 70.0}, {130.0, 70.0}}, 1.1);
    const ui::Input down = screen.frame();
    CHECK(holds(down, PointerButton::Middle));
    CHECK(!holds(down, PointerButton::Left));
    CHECK(*down.pointer == Point{80.0, 70.0});
    screen.touch({{40.0, 90.0}, {140.0, 90.0}}, 1.2);
    CHECK(*screen.frame().pointer == Point{90.0, 90.0});
    CHECK(screen.frame().wheel == Point{});
    screen.touch({{40.0, 90.0}}, 1.3);
    CHECK(!holds(screen.frame(), PointerButton::Middle));
    screen.touch({}, 1.4); // the last finger does nothing more
    for (int i = 0; i < 3; ++i) CHECK(!holds(screen.frame(), PointerButton::Left));
}

TEST_CASE("Fingers that part enlarge as much as they part")
{
    Screen screen;
    screen.touch({{100.0, 70.0}, {180.0, 70.0}}, 1.0);
    screen.touch({{90.0, 70.0}, {190.0, 70.0}}, 1.1);
    screen.touch({{60.0, 70.0}, {220.0, 70.0}}, 1.2); // of one frame
    CHECK(std::pow(1.15, screen.frame().wheel.y) == doctest::Approx(160.0 / 80.0));
    screen.touch({{100.0, 70.0}, {180.0, 70.0}}, 1.3);
    CHECK(std::pow(1.15, screen.frame().wheel.y) == doctest::Approx(80.0 / 160.0));
    screen.touch({{139.0, 70.0}, {141.0, 70.0}}, 1.4); // too near to tell
    CHECK(screen.frame().wheel == Point{});
}

TEST_SUITE_END();
