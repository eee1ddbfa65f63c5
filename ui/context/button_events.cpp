#include "ui/context/button_events.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace ui {

void ButtonEvents::deliver_next(Input& input)
{
    if (!waiting_.empty()) {
        const Event event = waiting_.front();
        waiting_.pop_front();
        const auto button = static_cast<std::size_t>(event.button);
        is_down_[button] = event.is_down;
        input.pointer = event.place;
        input.modifiers = event.modifiers;
        if (event.is_down)
            if (const auto before = std::exchange(pressed_at_[button], event.latest))
                input.since_press = std::max(0.0, event.earliest - *before);
    }
    input.is_button_down = is_down_;
}

} // namespace ui
