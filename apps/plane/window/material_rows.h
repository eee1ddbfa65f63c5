#pragma once

#include "apps/plane/session/commands.h"
#include "ui/widgets/number_field.h"

namespace plane {

/// The material of a region: which one it is, its numbers, and another one.
void material_rows(Workspace& workspace, ui::NumberFields& fields, RegionId region);

} // namespace plane
