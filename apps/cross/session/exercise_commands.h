#pragma once

#include "apps/cross/session/commands.h"

namespace cross {

/// Commands of a pupil's exercises.
void add_exercise_commands(CommandTable& table);

} // namespace cross
