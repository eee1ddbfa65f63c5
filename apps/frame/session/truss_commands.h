#pragma once

#include "apps/frame/session/commands.h"

namespace frame {

/// What is done with the Cremona diagram that is looked at.
void add_truss_commands(CommandTable& table);

/// The diagram that the picture shows; null where it shows none.
const CremonaPicture* shown_diagram(const Session& session);

} // namespace frame
