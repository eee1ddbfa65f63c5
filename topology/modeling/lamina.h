#pragma once

#include <vector>

#include "topology/halfedge/operators/euler_operator.h"

namespace topology {

/// A polygon of no thickness: two faces back to back in a shell of their own.
struct Lamina {
    FaceId front; ///< its loop runs as the points were given: it is seen counter-clockwise from its outside
    FaceId back;
    HalfEdgeId first; ///< of the front, from the first point to the second
};

/// MVFS, MEV to each further point, and one MEF: V = E = n, F = L = 2.   \pre three points or more
Lamina lamina(EulerOperator& op, const std::vector<Point>& points);

/// Struts one after another from a corner. \returns the half-edge that runs back from the last point, or the corner
HalfEdgeId wire(EulerOperator& op, HalfEdgeId corner, const std::vector<Point>& points);

/// An arc about the origin in the plane of x and z, from one angle to another (in rad, from x toward z): n + 1 points.
struct Arc {
    double radius = 1.0, from = 0.0, to = 0.0;
};
std::vector<Point> arc_points(const Arc& arc, int n);

/// A regular n-gon about the origin in the plane of x and y, counter-clockwise seen from above.
std::vector<Point> regular_polygon(int n, double radius);

} // namespace topology
