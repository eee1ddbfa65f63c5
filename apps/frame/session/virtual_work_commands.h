#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// Why no displacement can be looked at as virtual work; nothing where one can.
ui::Reason why_no_virtual_work(const Workspace& workspace);

/// Takes up its tool, at the node or in the middle of the member that is selected.
void begin_virtual_work(Workspace& workspace);

void add_virtual_work_commands(CommandTable& table);

/// The one that the picture shows; null where it shows none.
const drawing::WorkPicture* shown_work(const Session& session);

} // namespace frame
