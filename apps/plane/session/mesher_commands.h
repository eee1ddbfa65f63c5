#pragma once

#include "apps/plane/session/commands.h"

namespace plane {

/// Watches the mesh of the drawing being made: next step, back, by itself, faster.
void add_mesher_commands(CommandTable& table);

} // namespace plane
