#pragma once

#include "apps/euler/session/commands.h"

namespace euler {

/// The commands that walk through the lesson. Back is the inverse operator, and is named so.
void add_step_commands(CommandTable& table);

} // namespace euler
