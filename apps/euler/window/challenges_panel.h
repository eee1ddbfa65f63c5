#pragma once

#include "apps/euler/session/commands.h"

namespace euler {

/// The challenge that is on, with its answers, hints and verdict; below it the buttons that begin another.
void challenges_panel(Workspace& workspace, const CommandTable& commands);

} // namespace euler
