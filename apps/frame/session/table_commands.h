#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// The commands that open the panel at the bottom, choose what it shows and write its table to a file.
void add_table_commands(CommandTable& table);

/// "view.table.nodes"
std::string_view command_id(TableKind kind);

/// Which table stands in the panel, to be remembered from one time to the next: "table nodes"; nothing where none does.
std::string kept_words(const BottomView& bottom);
/// Opens the table that is named at the end of the words. None is, or an unknown one: nothing changes.
void take_up(BottomView& bottom, std::string_view words);

} // namespace frame
