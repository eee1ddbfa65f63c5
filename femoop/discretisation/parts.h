#pragma once

#include <cstddef>

#include "femoop/discretisation/discretisation.h"

namespace femoop {

/// Nodes that any member meets.
std::size_t n_joints(const Discretisation& structure);

/// The pieces that members join nodes to, supports or not; nodes without members do not count.
std::size_t n_parts(const Discretisation& structure);

/// The ways in which a rigid piece can move: as many equations of equilibrium it has.
constexpr int n_rigid_motions(AnalysisKind kind) { return is_3d(kind) ? 6 : 3; }

} // namespace femoop
