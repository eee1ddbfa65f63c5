#pragma once

#include <cstdint>
#include <span>

#include "ui/context/button_events.h"
#include "ui/context/input.h"

namespace ui {

/// What fingers do on a screen, as what a hand does with a mouse. A tap is a click; a finger that moves drags with the left
/// button; one that rests is a click of the right button; two move the view with the middle button, and zoom as the wheel
/// does. The left button goes down only once it is clear that a finger does nothing else.
class TouchGesture {
public:
    static constexpr double long_press = 0.6; ///< [s]

    /// \param fingers  that are down now, in the order in which they came [logical pixels]
    void follow(std::span<const Point> fingers, double time, ButtonEvents& buttons, Input& input);
    /// Call again and again. \returns whether a finger has rested for so long that something happens
    bool tick(double time, ButtonEvents& buttons);

private:
    enum class State : std::uint8_t { None, Waiting, Dragging, Moving, Over };

    void begin(Point place, double time);
    void wait(std::span<const Point> fingers, double time, ButtonEvents& buttons);
    void drag(std::span<const Point> fingers, double time, ButtonEvents& buttons);
    void begin_to_move(std::span<const Point> fingers, double time, ButtonEvents& buttons);
    void move(std::span<const Point> fingers, double time, ButtonEvents& buttons, Input& input);

    State state_ = State::None;
    Point place_{};       ///< of the first finger, or between two
    double begin_ = 0.0;  ///< when it went down [s]
    double spread_ = 0.0; ///< between two fingers
};

} // namespace ui
