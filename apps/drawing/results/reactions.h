#pragma once

#include "apps/drawing/results/solved_case.h"
#include "apps/drawing/sketch/scene.h"

namespace drawing {

/// What the supports do to the structure: an arrow with its value for every component that is not zero, clear of the
/// support's symbol.
void draw_reactions(const Scene& scene, const SolvedCase& solved);

} // namespace drawing
