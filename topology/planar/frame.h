#pragma once

#include <optional>

#include "topology/geometry/flat_point.h"
#include "topology/geometry/vector.h"
#include "topology/halfedge/solid.h"

namespace topology {

/// A plane with two axes of unit length at a right angle. It is looked at from where u x v points.
struct Frame {
    Point origin;
    Vector u{1.0, 0.0, 0.0}, v{0.0, 1.0, 0.0};

    FlatPoint flat(const Point& p) const { return {dot(u, p - origin), dot(v, p - origin)}; }
    Vector normal() const { return cross(u, v); }
};

/// The plane through a point that is looked at from where the normal points. \pre the normal has a length
Frame frame_across(const Point& origin, const Vector& normal);

/// The plane that all of a solid's vertices lie in, looked at from above or, if it stands upright, from the side of the
/// larger coordinate. Where they lie in a line, it is a plane through it, level if there is one. None where they lie in
/// no plane, or there are none.
/// Accuracy a vertex lies in the plane up to 1e-9 of the solid's extent
std::optional<Frame> plane_of(const Solid& solid);

} // namespace topology
