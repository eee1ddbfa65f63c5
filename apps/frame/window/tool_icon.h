#pragma once

#include "apps/frame/tools/tool_controller.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"

namespace frame {

/// The sign of a tool, on the whole of the painter's square sheet.
void draw_tool_icon(ui::Painter& painter, ToolKind tool, const ui::Theme& theme);

} // namespace frame
