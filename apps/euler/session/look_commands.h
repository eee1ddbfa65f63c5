#pragma once

#include "apps/euler/session/commands.h"

namespace euler {

/// The commands on how the solid is seen: from where, and with what.
void add_look_commands(CommandTable& table);
/// The commands on panels, theme and language.
void add_panel_commands(CommandTable& table);

} // namespace euler
