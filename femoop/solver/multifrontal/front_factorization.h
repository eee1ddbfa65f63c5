#pragma once

#include "femoop/solver/multifrontal/front_tree.h"
#include "femoop/solver/multifrontal/team.h"
#include "femoop/solver/symmetric_solver.h"

namespace femoop {

/// The numbers of a multifrontal factorization: \p entries [tree.n_entries()] becomes L with D on its diagonals. The
/// same bit for bit whatever the team's size. Ends soon after the first pivot that is not positive.
Pivots factorize_fronts(const FrontTree& tree, const SparseMatrix& K, double* entries, Team& team);

} // namespace femoop
