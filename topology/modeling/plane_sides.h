#pragma once

#include <optional>
#include <vector>

#include "topology/geometry/plane.h"
#include "topology/halfedge/solid.h"

namespace topology {

/// On which side of a plane the vertices of a solid count, so that a cut meets edges alone: one that lies on the plane
/// is taken for a point a hair's breadth above or below it. A face in the plane stays with the part that it bounds; of
/// other vertices those count as above from which an edge goes up.
struct PlaneSides {
    std::vector<double> height;   ///< by the vertex's number; 0: on the plane, to rounding
    std::vector<bool> is_above;   ///< likewise
    std::optional<VertexId> torn; ///< of faces in the plane whose parts lie on different sides: it has no side

    double height_of(VertexId v) const { return height[v.index]; }
    bool counts_as_above(VertexId v) const { return is_above[v.index]; }
};

PlaneSides sides_of(const Solid& solid, const Plane& plane);

} // namespace topology
