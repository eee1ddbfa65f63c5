#pragma once

#include <array>
#include <deque>
#include <optional>

#include "ui/context/input.h"

namespace ui {

/// The pointer's buttons between two frames. A frame knows only whether a button is down, so of two clicks within one
/// late frame it would see one: each frame gets one event with its place, and the others wait for the next frames.
class ButtonEvents {
public:
    struct Event {
        PointerButton button;
        bool is_down;
        Point place;
        Modifiers modifiers;
        double earliest, latest; ///< between these it happened [s]: what comes while a frame is drawn is heard after it
    };

    void add(const Event& event) { waiting_.push_back(event); }
    /// The next event: its place, its modifiers, and how long ago, at the least, its button went down before.
    void deliver_next(Input& input);

private:
    std::deque<Event> waiting_;
    std::array<bool, n_pointer_buttons> is_down_{};
    std::array<std::optional<double>, n_pointer_buttons> pressed_at_; ///< at the latest [s]
};

} // namespace ui
