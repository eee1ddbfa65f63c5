#pragma once

#include "femoop/solver/multifrontal/front_factor.h"
#include "femoop/solver/multifrontal/front_tree.h"
#include "femoop/solver/progress.h"
#include "femoop/solver/symmetric_solver.h"
#include "femoop/solver/team.h"

namespace femoop {

/// What is factored.
struct SystemNumbers {
    const SparseMatrix& K;
    const Eigen::VectorXd& reference; ///< what pivots are held against
    Signs signs = Signs::Positive;    ///< if any, the factor has room for an order and couplings
};

/// The numbers of a multifrontal factorization; \p factor has room for them. The same bit for bit whatever the team's
/// size. Ends soon after the first pivot that `signs` does not take.
/// \throws Cancelled
Pivots factorize_fronts(const FrontTree& tree, const SystemNumbers& system, FrontFactor& factor, Team& team,
                        const Progress& progress);

} // namespace femoop
