#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// Model and results in words, over the picture until it is closed; hidden results can be revealed there.
void description_window(Workspace& workspace, bool& is_open);

} // namespace frame
