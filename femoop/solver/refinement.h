#pragma once

#include <Eigen/Core>

#include "femoop/solver/symmetric_solver.h"

namespace femoop {

/// Solutions that their own residuals improved.
struct RefinedSolution {
    Eigen::MatrixXd X; ///< [unknowns x right-hand sides]
    /// By what part of itself any entry of K and B has to be changed, at most, for X to be exact: 1e-16 is as good as
    /// doubles can be.
    double backward_error = 0.0;
    int n_steps = 0; ///< corrections that were made
};

/// Solves K X = B and corrects X += K^-1 (B - K X) as long as that halves the backward error.
///
/// \pre `solver` holds a complete factorization of K (lower triangle).
/// Source  [ArioliDemmelDuff1989], backward error (1.3) with zero denominators passed over
RefinedSolution solve_refined(const SymmetricSolver& solver, const SparseMatrix& K, const Eigen::MatrixXd& B);

} // namespace femoop
