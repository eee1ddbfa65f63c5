#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// Windows to read in, over the picture, until they are closed.

/// Model and results in words; hidden results can be revealed there.
void description_window(Desk& desk, bool& is_open);
/// Every key and what it does, from the command table.
void shortcut_window(const Desk& desk, const CommandTable& commands, bool& is_open);

} // namespace frame
