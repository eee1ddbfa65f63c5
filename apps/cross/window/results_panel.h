#pragma once

#include "apps/cross/session/commands.h"

namespace cross {

/// The tables of the sheet, of its comparison with the stiffness method, of sways, convergence, Kani's method and the
/// slope-deflection equations; one at a time.
void results_panel(Workspace& workspace, const CommandTable& commands);

} // namespace cross
