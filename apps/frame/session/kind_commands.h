#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// Changes the kind of the structure - plane truss, space frame and so on - where every part of it has its meaning in
/// the new kind too; a notice names what has not.
void change_kind(Workspace& workspace, femoop::AnalysisKind kind);

/// A command for each kind.
void add_kind_commands(CommandTable& table);

} // namespace frame
