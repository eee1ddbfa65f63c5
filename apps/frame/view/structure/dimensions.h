#pragma once

#include "apps/frame/view/sketch/scene.h"

namespace frame {

/// Chains of dimension lines outside everything drawn so far: below and at the left in plane models, along x, y and z
/// in space. Each chain measures between neighbouring nodes, and over all when there are several.
void draw_dimensions(const Scene& scene);

} // namespace frame
