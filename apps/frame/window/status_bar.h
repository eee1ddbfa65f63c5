#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// The foot of the window: how large the structure is, how determinate or why it is not solved, and its units.
void status_bar(const Workspace& workspace);

} // namespace frame
