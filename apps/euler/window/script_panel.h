#pragma once

#include "apps/euler/session/commands.h"

namespace euler {

/// The steps of the script as lines; a click goes there.
void script_panel(Desk& desk);

} // namespace euler
