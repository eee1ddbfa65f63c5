#include "ui/context/touch_gesture.h"

#include <cmath>
#include <utility>

namespace ui {

namespace {

constexpr double reach = 8.0;          // of a finger that rests [logical pixels]
constexpr double notch = 1.15;         // of the wheel (ui/app/canvas.h)
constexpr double smallest_spread = 20; // below it two fingers tell no zoom [logical pixels]

void press(ButtonEvents& buttons, PointerButton button, bool is_down, Point place, double time)
{
    buttons.add({button, is_down, place, {}, time, time});
}

void click(ButtonEvents& buttons, PointerButton button, Point place, double time)
{
    press(buttons, button, true, place, time);
    press(buttons, button, false, place, time);
}

Point middle(std::span<const Point> fingers) { return 0.5 * (fingers[0] + fingers[1]); }

} // namespace

void TouchGesture::follow(std::span<const Point> fingers, double time, ButtonEvents& buttons, Input& input)
{
    switch (state_) {
    case State::None:
        if (!fingers.empty()) begin(fingers[0], time);
        if (fingers.size() > 1) begin_to_move(fingers, time, buttons);
        break;
    case State::Waiting: wait(fingers, time, buttons); break;
    case State::Dragging: drag(fingers, time, buttons); break;
    case State::Moving: move(fingers, time, buttons, input); break;
    case State::Over:
        if (fingers.empty()) state_ = State::None;
        return;
    }
    input.pointer = place_;
}

bool TouchGesture::tick(double time, ButtonEvents& buttons)
{
    if (state_ != State::Waiting || time - begin_ < long_press) return false;
    click(buttons, PointerButton::Right, place_, time);
    state_ = State::Over;
    return true;
}

void TouchGesture::begin(Point place, double time)
{
    state_ = State::Waiting;
    place_ = place;
    begin_ = time;
}

void TouchGesture::wait(std::span<const Point> fingers, double time, ButtonEvents& buttons)
{
    if (fingers.empty()) {
        click(buttons, PointerButton::Left, place_, time);
        state_ = State::None;
    } else if (fingers.size() > 1) {
        begin_to_move(fingers, time, buttons);
    } else if (distance(fingers[0], place_) > reach) {
        press(buttons, PointerButton::Left, true, place_, begin_);
        state_ = State::Dragging;
        place_ = fingers[0];
    }
}

void TouchGesture::drag(std::span<const Point> fingers, double time, ButtonEvents& buttons)
{
    if (!fingers.empty()) {
        place_ = fingers[0];
        return;
    }
    press(buttons, PointerButton::Left, false, place_, time);
    state_ = State::None;
}

void TouchGesture::begin_to_move(std::span<const Point> fingers, double time, ButtonEvents& buttons)
{
    state_ = State::Moving;
    place_ = middle(fingers);
    spread_ = distance(fingers[0], fingers[1]);
    press(buttons, PointerButton::Middle, true, place_, time);
}

void TouchGesture::move(std::span<const Point> fingers, double time, ButtonEvents& buttons, Input& input)
{
    if (fingers.size() < 2) {
        press(buttons, PointerButton::Middle, false, place_, time);
        state_ = fingers.empty() ? State::None : State::Over;
        return;
    }
    place_ = middle(fingers);
    const double before = std::exchange(spread_, distance(fingers[0], fingers[1]));
    if (before > smallest_spread && spread_ > smallest_spread)
        input.wheel = input.wheel + Point{0.0, std::log(spread_ / before) / std::log(notch)};
}

} // namespace ui
