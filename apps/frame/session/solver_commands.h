#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// The panel where the solver is watched at work, its steps and its orders of elimination.
void add_solver_commands(CommandTable& table);

} // namespace frame
