#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// Why no part can be lifted out; nothing where one can.
ui::Reason why_no_free_body(const Workspace& workspace);

void add_free_body_commands(CommandTable& table);

} // namespace frame
