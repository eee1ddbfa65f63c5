#pragma once

#include "apps/euler/session/commands.h"
#include "ui/context/imgui_session.h"
#include "ui/paint/painter.h"

namespace euler {

/// The selected entity and its pointers, each of which leads to another, as boxes and arrows and as a list. Nothing
/// where none is selected.
void entity_panel(Session& session, ui::ImGuiSession& gui, const ui::Fonts& fonts);

} // namespace euler
