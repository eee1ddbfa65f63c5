#pragma once

#include "apps/drawing/sketch/scene.h"

namespace drawing {

/// The dimension lines that were drawn by hand (ViewOptions::dimensions), each with lines that lead to it from its
/// nodes. In a structure in space there are none.
void draw_drawn_dimensions(const Scene& scene);

/// Where they run, so that a fitted picture has them whole.
std::vector<Eigen::Vector3d> ends_of_dimensions(const femoop::Model& model, const ViewOptions& options);

} // namespace drawing
