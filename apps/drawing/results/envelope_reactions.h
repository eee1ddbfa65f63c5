#pragma once

#include "apps/drawing/results/solved_case.h"
#include "apps/drawing/sketch/scene.h"

#include <vector>

namespace drawing {

/// What each support does at least and at most over several cases, in words beside it, with the cases that govern:
/// "fy 30.1 (G) … 54.3 (U1) kN". Signs are those of the model's axes.
void draw_reaction_ranges(const Scene& scene, const std::vector<SolvedCase>& cases);

} // namespace drawing
