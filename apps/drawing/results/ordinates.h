#pragma once

#include "apps/drawing/results/line_function.h"
#include "apps/drawing/sketch/scene.h"
#include "femoop/result/results.h"

#include <vector>

namespace drawing {

bool is_moment(femoop::MemberComponent component); ///< bending, not torsion

/// Whether numbers beside the diagram carry their sign; the side alone says it of moments on the tension side.
bool has_signs(const Scene& scene, femoop::MemberComponent component);

/// The frame in which a member's diagram is drawn: x along the member, y to where positive values are drawn.
SymbolFrame diagram_frame(const Scene& scene, const MemberShape& member, femoop::MemberComponent component);

/// A value at a place of a line.
struct Ordinate {
    double x;
    double value;
};

/// Values along a line, close enough together that the line between them is the curve to within the tolerance; both
/// sides of a jump.
std::vector<Ordinate> ordinates_of(const LineFunction& function, double tolerance);

} // namespace drawing
