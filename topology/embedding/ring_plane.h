#pragma once

#include <optional>

#include "topology/halfedge/operators/change.h"
#include "topology/halfedge/solid.h"

namespace topology {

/// A vertex of a ring, and the face in whose plane it should lie.
struct OffPlane {
    VertexId vertex;
    FaceId face;
};

/// A ring that KEMR, MVR, KFMRH or RINGMV gave to a face in whose plane it does not lie: the links are right, but what
/// they bound is no flat face. Told is the ring's vertex that is farthest from the plane of the outer loop. Nothing
/// where all lie as near to it as the outer loop itself does, or the outer loop encloses no area.
/// Accuracy distances up to 1e-9 of the face's extent are none
std::optional<OffPlane> off_plane(const Solid& after, const Change& change);

} // namespace topology
