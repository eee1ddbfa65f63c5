#pragma once

#include <string>

#include "apps/euler/session/commands.h"

namespace euler {

/// The commands that begin an operator, one for each of the palette, and those that end it.
void add_operator_commands(CommandTable& table);

/// Brings the palette forth, with what is asked.
void show_operators(Workspace& workspace);

/// "operator.mev"
std::string command_id(const OperatorForm& form);

} // namespace euler
