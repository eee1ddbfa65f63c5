#pragma once

#include "apps/plane/tools/hand.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"

namespace plane {

/// A tool as a little picture that fills the painter's sheet.
void draw_tool_icon(ui::Painter& painter, ToolKind tool, const ui::Theme& theme);

} // namespace plane
