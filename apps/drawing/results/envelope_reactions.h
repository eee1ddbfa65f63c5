#pragma once

#include "apps/drawing/results/envelope_band.h"
#include "apps/drawing/sketch/scene.h"

namespace drawing {

/// What each support does at least and at most, in words beside it, with the cases or trains that govern:
/// "fy 30.1 (G) … 54.3 (U1) kN". Signs are those of the model's axes.
void draw_reaction_ranges(const Scene& scene, const EnvelopePicture& envelope);

} // namespace drawing
