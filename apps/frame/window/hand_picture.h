#pragma once

#include "apps/drawing/geometry/projection.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/session/session.h"
#include "apps/frame/tools/tool_controller.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"

namespace frame {

/// Draws over the picture what the hand is about to do: the grid, the place that is meant and what drew it there, the
/// line with its length and angle, the window of a selection, what is typed.
void draw_hand(ui::Painter& painter, const Session& session, const ToolController& tool_controller,
               const Projection& projection, const ui::Theme& theme);
/// What is typed alone, in the middle of the picture's foot: while the pointer is elsewhere.
void draw_typed(ui::Painter& painter, const ToolController& tool_controller, const ui::Theme& theme);

} // namespace frame
