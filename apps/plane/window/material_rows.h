#pragma once

#include <vector>

#include "apps/plane/session/commands.h"
#include "ui/widgets/number_field.h"

namespace plane {

/// The material of regions: which one it is, and where they have the same its numbers and another one.
void material_rows(Workspace& workspace, ui::NumberFields& fields, const std::vector<RegionId>& regions);

} // namespace plane
