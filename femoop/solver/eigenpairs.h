#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "femoop/solver/symmetric_solver.h"

namespace femoop {

/// Solutions of K x = w M x.
struct Eigenpairs {
    Eigen::VectorXd values;  ///< w, ascending
    Eigen::MatrixXd vectors; ///< a column each, of M-norm 1 and square to one another: X' M X = 1
    double rounding = 0.0;   ///< how far off a value may be by the rounding of K: what is less tells nothing
    bool is_counted = true;  ///< Sturm's count confirms that none below the last is missed
};

/// The lowest eigenpairs of a structure's stiffness and mass: `wanted` of them and those that have the value of the last
/// too, or all if these are fewer, as where few unknowns have mass.
///
///      (K - s M)^-1 M x = x / (w - s)      s = 0, or below all w where K lets something move
///
/// \param K, M    lower triangles of the same unknowns, positive semidefinite; M has entries only where K has
/// \param solver  analysed for K; what it holds afterwards is of no use
/// \pre    it takes Signs::Any
/// \throws std::range_error   if the values of K and M are no numbers, or too unlike to be divided
/// \throws std::domain_error  if something moves that has neither stiffness nor mass
/// \throws InsufficientMemory
/// \throws Cancelled
///
/// Method  Lanczos' in blocks with all vectors kept square to one another, restarted from the best of them, on the
///         inverse [GolubVanLoan, sec. 10.3]; multiple eigenvalues come out of blocks and of what Sturm's count finds
///         missing: K - s M has as many negative pivots as there are eigenvalues below s [Bathe1996, sec. 11.6]
Eigenpairs lowest_eigenpairs(const SparseMatrix& K, const SparseMatrix& M, std::size_t wanted, SymmetricSolver& solver);

} // namespace femoop
