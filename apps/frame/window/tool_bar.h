#pragma once

#include "apps/frame/session/commands.h"
#include "ui/context/imgui_session.h"
#include "ui/paint/text_measure.h"
#include "ui/widgets/number_field.h"

namespace frame {

/// The row of tools over the picture, with the settings of the tool in the hand beside them.
void tool_bar(Workspace& workspace, const CommandTable& commands, ui::ImGuiSession& gui, const ui::Fonts& fonts,
              ui::NumberFields& fields);

} // namespace frame
