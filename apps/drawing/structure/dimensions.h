#pragma once

#include "apps/drawing/sketch/scene.h"

#include <cstdint>
#include <vector>

namespace drawing {

/// Chains of dimension lines outside everything drawn so far: below and at the left in plane models, along x, y and z
/// in space. Each chain measures between neighbouring nodes, and over all when there are several and totals are drawn.
enum class Totals : std::uint8_t { Drawn, LeftOut };
void draw_dimensions(const Scene& scene, Totals totals = Totals::Drawn);

/// Where the chains of a structure in space begin and end: corners of the box around its nodes, which may lie far from
/// any node.
std::vector<Eigen::Vector3d> dimensioned_corners(const StructureShape& shape);

} // namespace drawing
