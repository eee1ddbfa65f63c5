#pragma once

#include <string_view>

#include "apps/euler/session/commands.h"

namespace euler {

/// A button for a command, under its label; grey, with the reason under the pointer, where it cannot run.
void command_button(Desk& desk, const CommandTable& commands, std::string_view id);

} // namespace euler
