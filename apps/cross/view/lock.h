#pragma once

#include "apps/frame/view/sketch/sketch.h"

namespace cross {

/// A padlock on a joint: shut while the joint is clamped, open while it turns.
///
///      .-.        .-.
///      | |          |
///     [===]      [===]
///      shut       open
struct Lock {
    ui::Point at; ///< its middle
    bool is_shut = true;
};
void draw(frame::Sketch& sketch, const Lock& lock);

} // namespace cross
