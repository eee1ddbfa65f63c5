#pragma once

#include "apps/mohr/session/commands.h"
#include "ui/context/imgui_session.h"

namespace mohr {

/// The steps of the construction as sentences; a click on one goes there.
void construction_panel(Workspace& workspace, const CommandTable& commands, ui::ImGuiSession& gui);

} // namespace mohr
