#pragma once

#include <Eigen/Core>

#include "femoop/solver/multifrontal/front_factor.h"
#include "femoop/solver/multifrontal/front_tree.h"
#include "femoop/solver/team.h"

namespace femoop {

/// Solves L D L' X = B, one column for each right-hand side.
Eigen::MatrixXd solve_fronts(const FrontTree& tree, const FrontFactor& factor, Eigen::MatrixXd B, Team& team);

} // namespace femoop
