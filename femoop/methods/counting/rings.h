#pragma once

#include <Eigen/Core>
#include <vector>

#include "femoop/discretisation/discretisation.h"

namespace femoop::counting {

/// A closed ring of members.
struct Ring {
    std::vector<MemberId> members; ///< one after the other where it is simple
    Eigen::Vector3d middle;        ///< a place within it, for a label [length]
};

/// Independent closed rings of members, as many as n_members - n_joints + n_parts: no ring is the sum of others.
///
///      o-----o-----o
///      |  1  |  2  |        of a plane drawing its meshes; in space, and where members cross without a node, short
///      o-----o-----o        rings one after the other
///
/// From below to above, and from left to right.
std::vector<Ring> rings(const Discretisation& structure);

} // namespace femoop::counting
