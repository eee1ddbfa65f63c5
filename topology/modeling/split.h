#pragma once

#include <vector>

#include "topology/geometry/plane.h"
#include "topology/halfedge/operators/euler_operator.h"

namespace topology {

/// The faces that close the parts at the plane.
struct Split {
    std::vector<FaceId> above, below; ///< of the parts above and below
};

/// Cuts a solid in two at a plane: each part that comes apart is a shell of its own. Faces may have any outline, and
/// rings.
///
/// SEMV where edges cross the plane, MEF or MEKR along each face's cut; then around each closed cut MEV and MEF make a
/// band of no width, KEF and KEMR make one face of it, and MFKRH opens that into two. Where one cut lies inside
/// another, KFMRH makes it a ring of that one's face. A vertex on the plane is cut as if it lay a hair's breadth
/// beside it (plane_sides.h); KEV and KEF then take away edges of no length and faces of no width.
/// Assumes  planar faces, right side out; refused where faces in the plane meet at a vertex from both sides
/// Source   the idea of null edges: [Mantyla1988, ch. 14]
Split split(EulerOperator& op, const Plane& plane);
std::optional<Refusal> why_not_split(const EulerOperator& op, const Plane& plane);

} // namespace topology
