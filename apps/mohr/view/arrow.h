#pragma once

#include "ui/paint/painter.h"

namespace mohr {

/// A line with a head at its end; the head is shorter where the line is.
void arrow(ui::Painter& painter, ui::Point from, ui::Point to, const ui::Stroke& stroke, double head);

/// The same line without dashes: an arrow is too short for them.
ui::Stroke solid(ui::Stroke stroke);

/// A part of a circle about `center` from angle `start` through `sweep`, with a head at its end (radians, as seen).
void arc_arrow(ui::Painter& painter, const ui::Arc& arc, const ui::Stroke& stroke, double head);

} // namespace mohr
