#pragma once

#include <span>

#include "apps/euler/session/commands.h"

namespace euler {

/// The commands that begin a challenge, ask for a hint, and give it up.
void add_challenge_commands(CommandTable& table);

/// Those that begin one, for the panel's buttons.
std::span<const std::string_view> challenge_command_ids();

} // namespace euler
