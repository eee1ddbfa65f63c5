#pragma once

#include <vector>

#include "topology/geometry/vector.h"
#include "topology/halfedge/operators/euler_operator.h"

namespace topology {

/// The points p with normal . (p - origin) = 0; above is where the normal points.
struct Plane {
    Point origin;
    Vector normal{0.0, 0.0, 1.0};

    double height(const Point& p) const { return dot(normal, p - origin); } ///< times the normal's length
};

/// The faces that close the parts at the plane.
struct Split {
    std::vector<FaceId> above, below; ///< of the parts above and below
};

/// Cuts a solid in two at a plane: each part that comes apart is a shell of its own. Faces may have any outline, and
/// rings.
///
/// SEMV where edges cross the plane, MEF or MEKR along each face's cut; then around each closed cut MEV and MEF make a
/// band of no width, KEF and KEMR make one face of it, and MFKRH opens that into two. Where one cut lies inside
/// another, KFMRH makes it a ring of that one's face. Assumes  planar faces, right side out; no vertex lies on the
/// plane (move the plane a little) Source   the idea of null edges: M. Mantyla, An Introduction to Solid Modeling,
/// chapter 14
Split split(EulerOperator& op, const Plane& plane);
std::optional<Refusal> why_not_split(const EulerOperator& op, const Plane& plane);

} // namespace topology
