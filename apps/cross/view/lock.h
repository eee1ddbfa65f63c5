#pragma once

#include "apps/drawing/sketch/sketch.h"

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
void draw(drawing::Sketch& sketch, const Lock& lock);

} // namespace cross
