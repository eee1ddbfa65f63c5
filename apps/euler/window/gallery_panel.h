#pragma once

#include "apps/euler/session/commands.h"

namespace euler {

/// The ready scripts by their titles; a click begins one.
void gallery_panel(Workspace& workspace, const CommandTable& commands);

} // namespace euler
