#pragma once

#include "apps/drawing/sketch/scene.h"

namespace drawing {

/// The symbol of a plane model's support; see supports.h for which it is.
void draw_plane_support(const Scene& scene, femoop::NodeId node);

/// Where the symbol lies, in the model's axes; nothing where it has no side or there is no support.
std::optional<Eigen::Vector3d> plane_support_side(const Scene& scene, femoop::NodeId node);

/// The support's own x and y axes in the model's.
std::array<Eigen::Vector3d, 2> plane_support_axes(const femoop::Support& support);

} // namespace drawing
