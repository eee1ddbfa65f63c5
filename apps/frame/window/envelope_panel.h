#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// The results of an envelope: which load cases and combinations take part, and the largest and smallest section forces
/// and reactions with the case that governs. \pre the session has results of at least one case
void envelope_panel(Workspace& workspace);

} // namespace frame
