#pragma once

#include <vector>

#include "femoop/methods/mohr/construction.h"
#include "femoop/methods/mohr/space_state.h"

namespace femoop::mohr {

/// How the three circles of a state in space are drawn, and where a plane's point lies between them. Shear is a size
/// here, so all happens above the axis.
///
/// All planes whose normal makes one angle with direction 1 lie on an arc about the centre of the circle over the
/// second and the third value. It goes through the points of the other two circles that a line from the first value
/// reaches, inclined to the upright by that angle. Likewise from the third value, with arcs about the centre of the
/// circle over the first and the second. Two such arcs fix the point.
///
/// \param normal  of the plane, any length but 0
/// Source  [Mohr1882]; [TimoshenkoGoodier1970], stress at a point in three dimensions
std::vector<ConstructionStep> construction(const SpacePrincipal& principal, const Eigen::Vector3d& normal);

/// The angle between a plane's normal and a principal direction, 0 to pi/2.
double angle_with(const SpacePrincipal& principal, int direction, const Eigen::Vector3d& normal);

} // namespace femoop::mohr
