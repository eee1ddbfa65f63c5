#include "ui/context/button_events.h"

#include <doctest/doctest.h>

TEST_SUITE_BEGIN("button events");

using ui::ButtonEvents;
using ui::PointerButton;

namespace {

ButtonEvents::Event left(bool is_down, double earliest, double latest, ui::Point place = {})
{
    return {PointerButton::Left, is_down, place, {}, earliest, latest};
}

ui::Input next(ButtonEvents& events)
{
    ui::Input input;
    events.deliver_next(input);
    return input;
}

} // namespace

TEST_CASE("Two clicks within one late frame are two clicks")
{
    ButtonEvents events;
    for (int i = 0; i < 2; ++i)
        for (const bool is_down : {true, false}) events.add(left(is_down, 7.0, 7.9));
    for (const bool is_down : {true, false, true, false, false}) CHECK(next(events).is_button_down[0] == is_down);
}

TEST_CASE("A press is told at its own place with its own modifiers, and so is the release")
{
    ButtonEvents events;
    events.add({PointerButton::Left, true, {31.0, 17.0}, {.ctrl = true}, 2.0, 2.0});
    events.add({PointerButton::Left, false, {44.0, 19.0}, {}, 2.1, 2.1});
    const ui::Input press = next(events), release = next(events), after = next(events);
    CHECK(*press.pointer == ui::Point{31.0, 17.0});
    CHECK(press.modifiers.ctrl);
    CHECK(*release.pointer == ui::Point{44.0, 19.0});
    CHECK_FALSE(release.modifiers.ctrl);
    CHECK_FALSE(after.pointer);
}

TEST_CASE("Between two presses the hand took no longer than the frames leave open")
{
    ButtonEvents events;
    events.add(left(true, 1.0, 1.0));
    CHECK_FALSE(next(events).since_press);
    events.add(left(true, 1.02, 1.9)); // while a frame of 0.88 s was drawn
    CHECK(*next(events).since_press == doctest::Approx(0.02));
    events.add(left(true, 1.8, 1.9)); // in the same one
    CHECK(*next(events).since_press == 0.0);
    events.add(left(true, 4.6, 4.6));
    CHECK(*next(events).since_press == doctest::Approx(2.7));
}

TEST_CASE("A button knows nothing of another's press")
{
    ButtonEvents events;
    events.add(left(true, 1.0, 1.0));
    events.add({PointerButton::Right, true, {}, {}, 1.3, 1.3});
    CHECK_FALSE(next(events).since_press);
    const ui::Input both = next(events);
    CHECK_FALSE(both.since_press);
    CHECK(both.is_button_down[0]);
    CHECK(both.is_button_down[1]);
}
