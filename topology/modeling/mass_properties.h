#pragma once

#include <vector>

#include "topology/geometry/vector.h"
#include "topology/halfedge/solid.h"

namespace topology {

/// Of a face: its area times its normal, to the outside. Rings take their part away, as they run the other way.
Vector area_vector(const Solid& solid, FaceId f);

struct MassProperties {
    double area = 0.0;   ///< of the surface, voids included
    double volume = 0.0; ///< negative of a solid that is inside out
    Point centroid;      ///< of the volume; the first vertex where there is no volume
};

/// Units    any unit of length: area in its square, volume in its cube
/// Assumes  planar faces, outer loops counter-clockwise seen from outside, rings clockwise
/// Accuracy exact but for round-off, whatever the faces' outline; lengths are taken from the first vertex
MassProperties mass_properties(const Solid& solid);
MassProperties mass_properties(const Solid& solid, const std::vector<FaceId>& faces); ///< of the shell that they are

} // namespace topology
