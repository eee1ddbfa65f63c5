#pragma once

#include "apps/plane/session/commands.h"

namespace plane {

/// How a region is to be meshed: method, element and formulation; what is not chosen is the file's.
void mesh_rows(Workspace& workspace, RegionId region);

} // namespace plane
