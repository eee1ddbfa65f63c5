#pragma once

#include "apps/plane/view/plate_scene.h"

namespace plane {

/// The loads of the case that is shown, each times its factor in a combination: arrows at points; along curves rows of
/// arrows as long as the load is large, on the side without material, with their values at the ends and where they are
/// largest; inside regions body forces, temperatures and rotations; settlements.
void draw_loads(const PlateScene& scene);

/// Self-weight as a line of the head says it; empty where there is none.
std::string self_weight_text(const femoop::plane::PlaneModel& model, const PlateOptions& options);

} // namespace plane
