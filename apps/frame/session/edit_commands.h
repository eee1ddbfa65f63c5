#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// The commands that draw and change: tools, selection, undo, delete, nudges.
void add_tool_commands(CommandTable& table);
void add_edit_commands(CommandTable& table);
/// The tools that ask for something at a place, such as an influence line.
void add_method_tools(CommandTable& table);

/// Begins, ends or gives up a transformation of the selection by numbers.
void begin_transform(Workspace& workspace, Transform::Kind kind);
/// Its numbers are others now. Where these cannot be, what was before is still shown, and why is returned.
std::optional<ui::Message> change_transform(Workspace& workspace);
void accept_transform(Workspace& workspace);
void cancel_transform(Workspace& workspace);

/// The commands that take up a tool, in the order of the tool bar.
using ToolEntry = ui::Choice<ToolKind>;
std::span<const ToolEntry> tools();

} // namespace frame
