#pragma once

#include "apps/euler/session/commands.h"

namespace euler {

/// The commands that show a script of the gallery, from its beginning, in the gallery's order: "gallery.cube".
void add_gallery_commands(CommandTable& table);

/// Of the gallery's scripts, in its order.
std::span<const std::string> gallery_command_ids();

} // namespace euler
