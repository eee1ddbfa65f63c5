#pragma once

#include "apps/plane/session/commands.h"
#include "ui/widgets/number_field.h"

namespace plane {

/// Title, kind of analysis, load cases, and all regions, curves and points; a click selects one.
void model_panel(Workspace& workspace, const CommandTable& commands, ui::NumberFields& fields);

/// Everything wrong with the drawing; a click goes to the place.
void problems_panel(Workspace& workspace, const CommandTable& commands);

} // namespace plane
