#pragma once

#include "apps/euler/session/commands.h"

namespace euler {

/// The selected entity and its pointers, each of which leads to another. Nothing where none is selected.
void entity_panel(Session& session);

} // namespace euler
