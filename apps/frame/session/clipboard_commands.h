#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// Copy, cut and paste, within a document and from one tab to another.
void add_clipboard_commands(CommandTable& table);

} // namespace frame
