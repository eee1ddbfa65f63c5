#pragma once

#include <vector>

#include "femoop/methods/free_body/free_body.h"

namespace femoop::free_body {

/// None where fewer than three bars are cut, where a member is cut that carries more than normal force, or where the
/// structure is not plane.
std::vector<RitterPoint> ritter_points(const Discretisation& structure, const Body& body,
                                       const std::vector<Force>& forces);

/// The force of its bar, tension positive, from the moments of all else about the point.
struct RitterForce {
    std::vector<MomentTerm> moments; ///< of what has an arm, in the order of the body's forces
    double force = 0.0;              ///< minus their sum, by the arm
};
RitterForce ritter_force(const FreeBody& body, const RitterPoint& point);

} // namespace femoop::free_body
