#pragma once

#include "apps/cross/view/panels.h"
#include "apps/cross/view/scene.h"

namespace cross {

/// The sheet gets the room of the pictures that are not shown; the moments come next to the structure once it is right.
/// \pre the scene has a worksheet
Panels exercise_panels(const drawing::StructureShape& shape, ui::Size size, const Scene& scene, const SheetRoom& room,
                       BeamColumns columns = BeamColumns::Below);

} // namespace cross
