#pragma once

#include "apps/plane/session/commands.h"
#include "ui/context/imgui_session.h"
#include "ui/paint/text_measure.h"
#include "ui/widgets/number_field.h"

namespace plane {

/// The row of tools over the picture.
void tool_bar(Workspace& workspace, const CommandTable& commands, ui::ImGuiSession& gui, const ui::Fonts& fonts);

/// The panel at the left: what is shown, and what places are drawn to.
void show_panel(Workspace& workspace, const CommandTable& commands, ui::NumberFields& number_fields);

} // namespace plane
