#pragma once

#include "femoop/model/model.h"

namespace femoop {

/// Mends what drawing and moving can leave behind: nodes at one place (nearer than `nearness_of`) become one node,
/// members between the same two nodes one member, a member whose ends became one node goes, and a member that passes a
/// node is cut there (femoop/edit/split.h). Of two the earlier stays; supports and hinges of either and the loads of
/// both are kept, a settlement of the later only where the earlier has none.
void weld(Model& model);

} // namespace femoop
