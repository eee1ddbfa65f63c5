#pragma once

#include "apps/frame/session/commands.h"
#include "ui/widgets/number_field.h"

namespace frame {

/// Tables of displacements, reactions and section forces of the case that is shown; a row that is clicked is selected.
void results_panel(Workspace& workspace, ui::NumberFields& fields);

/// Errors, warnings and mechanisms, each a sentence; a click goes to its place.
void problems_panel(Workspace& workspace);

/// The steps of the history; a click jumps there.
void history_panel(Workspace& workspace);

} // namespace frame
