#pragma once

#include "apps/euler/session/commands.h"
#include "ui/context/imgui_session.h"
#include "ui/paint/painter.h"

namespace euler {

/// The buttons that walk through the lesson, the bar that is scrubbed, and the speed.
void player_bar(Workspace& workspace, const CommandTable& commands, ui::ImGuiSession& gui, const ui::Fonts& fonts);

} // namespace euler
