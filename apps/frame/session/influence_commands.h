#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// What is done with the influence line that is looked at.
void add_influence_commands(CommandTable& table);

/// Why nothing can be done with it: none is shown; nothing where one is.
std::optional<ui::Message> needs_influence_line(const Workspace& workspace);

/// Why none can be asked for; nothing where one can.
std::optional<ui::Message> why_no_influence_line(const Workspace& workspace);

} // namespace frame
