#pragma once

#include "apps/mohr/session/session.h"
#include "ui/context/imgui_session.h"

namespace mohr {

/// The tensor in its own and in the turned axes, every result, and what is special about the state.
void results_panel(const Session& session, ui::ImGuiSession& gui);

} // namespace mohr
