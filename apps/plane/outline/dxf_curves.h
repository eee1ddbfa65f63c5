#pragma once

#include <vector>

#include "apps/plane/outline/curve.h"

namespace outline {

/// A corner of a polyline with how far the side behind it bulges: the tangent of a quarter of the angle that it turns
/// through, positive counter-clockwise, 0 where it is straight.
struct BulgedCorner {
    Place at;
    double bulge = 0.0;
};

/// The straight runs and the arcs of a polyline, one after the other.
std::vector<Curve> bulged_polyline(const std::vector<BulgedCorner>& corners, bool is_closed);

/// The pieces of a B-spline of degree 1, 2 or 3, exactly, as cubics.
/// Source  Ramshaw, Blossoms are polar forms (1989): the control points of a piece are the spline's blossom at its ends
/// \pre knots ascend, and are as many as control points + degree + 1
Curve bspline(const std::vector<Place>& control, const std::vector<double>& knots, int degree);

} // namespace outline
