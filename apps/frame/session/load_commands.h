#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "apps/frame/session/commands.h"

namespace frame {

/// The commands that put loads, settlements and springs on the selected nodes and members, each as one step. Without
/// any selected the forces and line loads are taken up as the load tool.
void add_load_commands(CommandTable& table);

/// Why what is shown takes no load: a combination and the envelope have none of their own.
std::optional<ui::Message> why_shown_case_takes_no_load(const Session& session);

/// The ids of those that nodes can have, and members, in a structure of this kind.
std::vector<std::string_view> loads_for_nodes(femoop::AnalysisKind kind);
std::vector<std::string_view> loads_for_members(femoop::AnalysisKind kind);

/// The node or member that a load or settlement acts on. \pre the part is one
Part bearer_of(const femoop::Model& model, const Part& load);
bool is_load(const Part& part);

} // namespace frame
