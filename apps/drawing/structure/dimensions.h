#pragma once

#include "apps/drawing/sketch/scene.h"

#include <cstdint>
#include <vector>

namespace drawing {

/// Chains of dimension lines outside everything drawn so far: below and at the left in plane models, along x, y and z
/// in space. Each chain measures between neighbouring nodes, and over all when there are several; brief chains, which
/// take the least room, have no totals, and the heights of a plane model stand between their chain and the structure.
enum class Chains : std::uint8_t { Full, Brief };
void draw_dimensions(const Scene& scene, Chains chains = Chains::Full);

/// Where the chains of a structure in space begin and end: corners of the box around its nodes, which may lie far from
/// any node.
std::vector<Eigen::Vector3d> dimensioned_corners(const StructureShape& shape);

} // namespace drawing
