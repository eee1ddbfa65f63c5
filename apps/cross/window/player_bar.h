#pragma once

#include "apps/cross/session/commands.h"

namespace cross {

/// Buttons that lock everything again, step back, play, step and go through, and a bar on which one jumps to any step.
void player_bar(Workspace& workspace, const CommandTable& commands);

} // namespace cross
