#pragma once

#include "apps/drawing/sketch/scene.h"

namespace drawing {

/// The symbol of a support of a grillage or of a model in space; see supports.h for which it is.
void draw_space_support(const Scene& scene, femoop::NodeId node);

/// Where the symbol lies, in the model's axes: down where no member is in the way.
Eigen::Vector3d space_support_side(const Scene& scene, femoop::NodeId node);

} // namespace drawing
