#pragma once

#include "topology/geometry/vector.h"

namespace topology {

/// The points p with normal . (p - origin) = 0; above is where the normal points.
struct Plane {
    Point origin;
    Vector normal{0.0, 0.0, 1.0};

    double height(const Point& p) const { return dot(normal, p - origin); } ///< times the normal's length
};

} // namespace topology
