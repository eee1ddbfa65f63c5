#pragma once

#include <Eigen/Core>
#include <vector>

#include "femoop/methods/free_body/free_body.h"

namespace femoop::free_body {

/// Of a body that is cut off through bars: the point in which the lines of all bars meet but one. Moments about it leave
/// the force of that bar alone unknown.
/// Source  [TimoshenkoYoung1965, ch. 2]
struct RitterPoint {
    MemberId bar;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    double arm = 0.0; ///< of the bar's tension on the body, counter-clockwise positive
};

/// Of every bar that has one, in the order of the body's pieces. None where fewer than three are cut, where a member is
/// that carries more than normal force, or where the structure is not plane.
std::vector<RitterPoint> ritter_points(const FreeBody& body, const Model& model);

/// The force of its bar, tension positive, from the moments of all else about the point.
struct RitterForce {
    std::vector<double> moments; ///< of what has an arm, in the order of the body's forces
    double force = 0.0;          ///< minus their sum, by the arm
};
RitterForce ritter_force(const FreeBody& body, const RitterPoint& point);

} // namespace femoop::free_body
