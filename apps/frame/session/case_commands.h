#pragma once

#include <string>

#include "apps/frame/session/commands.h"

namespace frame {

/// The commands on load cases and combinations: new ones, and what is done to the one that is shown.
void add_case_commands(CommandTable& table);

/// Shows a load case or combination, and no envelope any more; where a case is selected it becomes the selection, so
/// that what is changed is what is seen. \pre the model has it
void show_case(Session& session, femoop::CaseId id);

/// \returns why the case cannot have this name, else renames it. \pre the model has it
std::optional<ui::Message> rename(Session& session, femoop::CaseId id, const std::string& name);

} // namespace frame
