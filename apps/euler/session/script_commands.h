#pragma once

#include "apps/euler/session/commands.h"

namespace euler {

/// Writing the script: one more line, or the whole as a text.
void add_script_commands(CommandTable& table);

/// Brings the script forth, with the keyboard.
void show_script(Workspace& workspace);

} // namespace euler
