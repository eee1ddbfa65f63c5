#pragma once

#include <vector>

#include "apps/plane/session/commands.h"

namespace plane {

/// How regions are to be meshed: method, element and formulation; what is not chosen is the file's.
void mesh_rows(Workspace& workspace, const std::vector<RegionId>& regions);

} // namespace plane
