#pragma once

#include <vector>

#include "topology/halfedge/operators/euler_operator.h"

namespace topology {

/// Rotational sweep of an open profile about the z axis, in n steps. The profile lies in the plane of x and z, x > 0,
/// and begins and ends on the axis, from below upward, so that the solid's outside is on its right.
///
///        z                              the two ends are shared by all steps;
///        |-o                            a step grows a strut from every other vertex and closes
///        |  \  profile         ->       a triangle at each end and a quadrilateral between (MEV, MEF);
///        |   o                          the last step closes with MEF alone
///        |-o/
///
/// Of k edges: V = 2 + n (k - 1), F = n k, genus 0.   \pre n >= 3, k >= 2   \returns the last face
FaceId revolve(EulerOperator& op, const std::vector<Point>& profile, int n);

/// Rotational sweep of a closed profile that does not meet the z axis, in the plane of x and z, clockwise seen along y
/// (from x toward z), in k steps: k - 1 sweeps of the lamina's front, KFMRH of the last front with the back, which
/// makes a handle, and MEKR and MEF for the last band. Of n points: V = F = n k, genus 1.   \pre n, k >= 3
void revolve_closed(EulerOperator& op, const std::vector<Point>& profile, int k);

} // namespace topology
