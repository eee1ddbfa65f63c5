#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// The commands that open the panel at the bottom, choose what it shows and write its table to a file.
void add_table_commands(CommandTable& table);

/// "view.table.nodes"
std::string_view command_id(TableKind kind);

} // namespace frame
