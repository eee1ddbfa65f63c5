#pragma once

#include <string>
#include <vector>

#include "apps/plane/view/plate_scene.h"

namespace plane {

/// The state at a place of the body, line by line: where it is, displacements, stresses as they are read, principal ones.
std::vector<std::string> state_lines(const femoop::plane::PlaneResults& results, const femoop::plane::PlaneCase& result,
                                     const Eigen::Vector2d& at, const PlateOptions& options,
                                     const ui::DisplayUnits& units);

/// Every place that is asked for, with its state in a box beside it.
void draw_probes(const PlateScene& scene, const ui::Box& room);

} // namespace plane
