#pragma once

#include "apps/plane/view/plate_scene.h"

namespace plane {

/// Supports on points, as those of frames are drawn, and along curves on the side without material: the ground where
/// nothing moves, rollers where the curve slides along it, springs, and what else is held in words.
void draw_supports(const PlateScene& scene);

} // namespace plane
