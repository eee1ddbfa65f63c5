#pragma once

#include "apps/drawing/dimension.h"
#include "apps/drawing/sketch/scene.h"

#include <Eigen/Core>
#include <span>
#include <vector>

namespace drawing {

/// Dimension lines that were drawn by hand, each with lines that lead to it from its nodes. In a structure in space
/// there are none.
void draw_drawn_dimensions(const Scene& scene, std::span<const DimensionLine> dimensions);

/// Where they run, so that a fitted picture has them whole.
std::vector<Eigen::Vector3d> ends_of_dimensions(const femoop::Model& model, std::span<const DimensionLine> dimensions);

} // namespace drawing
