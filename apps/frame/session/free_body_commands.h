#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// Why no part can be lifted out; nothing where one can.
ui::Reason why_no_free_body(const Workspace& workspace);

/// The body that is lifted out and seen; null where none is.
const drawing::FreeBodyPicture* lifted_body(const Session& session);

/// Says by which members the structure hangs together across a line that was drawn to cut it.
void notify_uncut(Session& session);

void add_free_body_commands(CommandTable& table);

} // namespace frame
