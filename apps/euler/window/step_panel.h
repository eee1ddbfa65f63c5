#pragma once

#include "apps/euler/session/commands.h"
#include "ui/context/imgui_session.h"

namespace euler {

/// The step that is looked at: its operator, what it changed in the counts, the formula of Euler and Poincare, its
/// explanation and its inverse.
void step_panel(Workspace& workspace, const CommandTable& commands, const ui::ImGuiSession& gui);

/// The same in two lines, to be read from the last row: where no panel says it.
void step_caption(const Session& session, const ui::ImGuiSession& gui);

/// The step's line without its comment.
std::string code(const StepSummary& step);

/// The formula with the numbers of these counts: "8 − 12 + 6 − (6 − 6) − 2 (1 − 0) = 0".
std::string formula_text(const topology::EulerCounts& counts);

} // namespace euler
