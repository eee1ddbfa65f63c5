#pragma once

#include <Eigen/Core>
#include <vector>

#include "femoop/methods/cross/problem.h"

namespace femoop::cross {

/// Moments at every end, and rotations of the joints that belong to them.
struct Moments {
    const std::vector<double>& at_end;
    const std::vector<double>& rotation;
};

/// The force that each prop must hold, joints locked in a state of the loaded structure, by the virtual work of its
/// sway: the shears follow from the end moments.
std::vector<double> holding_forces(const Problem& problem, const Moments& moments);

/// The same in a state of one sway alone, moved by Sway::scale.
std::vector<double> holding_forces(const Problem& problem, const Moments& moments, const Sway& moved);

/// Displacements across its axis that a motion of the nodes gives a member's ends: (v1, 0, v2, 0).
Eigen::Vector4d across(const MemberAction& action, const std::vector<Eigen::Vector2d>& displacement);

} // namespace femoop::cross
