#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// The stages of a truss that is worked out by hand, each a line; a click goes there.
/// \pre shown_truss(workspace.session)
void truss_panel(Workspace& workspace);

} // namespace frame
