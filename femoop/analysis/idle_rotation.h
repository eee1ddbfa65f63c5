#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "femoop/analysis/equations.h"
#include "femoop/analysis/structure.h"

namespace femoop {

/// A rotation of a node that no member end and no support takes part in: all members are hinged there, or those that
/// are not can spin about their own axis. It is held, so that it makes no false mechanism; a moment on it is one.
struct HeldRotation {
    NodeId node;
    std::vector<std::int32_t> rows; ///< equations of the node's rotations
    std::vector<Dof> dofs;          ///< which they are
    Eigen::VectorXd direction;      ///< over rows, length 1
};

/// Finds the rotations that nothing takes part in and adds a stiffness to K that holds them; exact, since K does
/// nothing in their direction. `K` is the lower triangle over all unknowns.
std::vector<HeldRotation> hold_idle_rotations(const Structure& structure, const Equations& equations, SparseMatrix& K);

} // namespace femoop
