#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// Why no funicular can be looked at; nothing where one can.
ui::Reason why_no_funicular(const Workspace& workspace);

/// Takes up its tool, over the members that are selected.
void begin_funicular(Workspace& workspace);

void add_funicular_commands(CommandTable& table);

/// The one that the picture shows; null where it shows none.
const FunicularPicture* shown_funicular(const Session& session);

} // namespace frame
