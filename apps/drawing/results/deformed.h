#pragma once

#include "apps/drawing/results/solved_case.h"
#include "apps/drawing/sketch/scene.h"

namespace drawing {

/// The largest displacement of any node or of any point of a member, with the place.
struct LargestDisplacement {
    double value = 0.0;
    femoop::MemberId member;
    double x = 0.0; ///< along it
};
LargestDisplacement largest_displacement(const SolvedCase& solved);

/// The round factor by which displacements are drawn: the one asked for, else one that makes them, or where the scale is
/// locked those of then, up to a tenth of the structure or of the panel.
double deformation_scale(const Scene& scene, const SolvedCase& solved, ui::Size panel);

/// The deformed shape, each member by its exact curve, times `scale` and the phase.
void draw_deformed(const Scene& scene, const SolvedCase& solved, double scale);

} // namespace drawing
