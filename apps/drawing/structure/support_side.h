#pragma once

#include "apps/drawing/sketch/scene.h"

#include <span>

namespace drawing {

/// A direction on which a symbol may lie, and how unusual it looks there (0: where textbooks put it).
struct SideChoice {
    Eigen::Vector3d direction;
    double strangeness = 0.0;
};

/// The direction that is least occupied by members, counting how usual it is. \pre choices are not empty.
/// \param room_enough  cosine of the angle to the nearest member from which on a direction is as good as any other
Eigen::Vector3d least_occupied(const Scene& scene, femoop::NodeId node, std::span<const SideChoice> choices,
                               double room_enough = 0.3);

/// Notes that the symbol of a node's support lies from the node towards `side`, `length` in the picture, so that a hand
/// on it means the support.
void mark_support(const Scene& scene, femoop::NodeId node, const Eigen::Vector3d& side, double length);

} // namespace drawing
