#pragma once

#include "apps/frame/session/commands.h"
#include "ui/command/chord.h"
#include "ui/context/imgui_session.h"
#include "ui/paint/text_measure.h"

namespace frame {

/// The solver at work, in what is left of the current window of Dear ImGui's: a bar with the steps and the orders of
/// elimination, and the four pictures of a step (apps/frame/view/solver/solver_picture.h). It follows every edit.
void solver_panel(Workspace& workspace, ui::ImGuiSession& gui, const ui::Fonts& fonts);

/// Left and Right go from front to front, Home and End to the first and the last, the space bar lets it walk, Up and
/// Down change the order, Esc does nothing. False for other keys.
bool handle_solver_key(Workspace& workspace, const ui::Chord& chord);

} // namespace frame
