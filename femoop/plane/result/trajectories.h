#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "femoop/plane/analysis/plane_results.h"

namespace femoop::plane {

/// Which principal stress trajectories follow: s1, the larger one in the plane, or s2.
enum class PrincipalFamily : std::uint8_t { First, Second };

/// A line that runs along a principal direction all its way.
using Trajectory = std::vector<Eigen::Vector2d>;

/// Principal stress trajectories of one family, evenly spaced: no two come closer than half the spacing, and no place of
/// the body is much farther from one than the spacing. They end at the border, where they would come too close to
/// another, and at isotropic points, where both principal stresses are equal and no direction is one.
///
/// Method  midpoint rule along the direction of the smoothed stress, within regions; seeds beside lines that are there
/// Source  [JobardLefer1997]
std::vector<Trajectory> trajectories(const PlaneResults& results, const PlaneCase& result, PrincipalFamily family,
                                     double spacing);

} // namespace femoop::plane
