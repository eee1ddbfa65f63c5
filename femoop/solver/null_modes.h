#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <functional>
#include <limits>

#include "femoop/solver/symmetric_solver.h"

namespace femoop {

/// Of the largest diagonal entry of K: what cos(90 degrees) leaves is less, any real stiffness more.
inline constexpr double idle_diagonal = 1e-18;

/// The motions that a symmetric positive semidefinite matrix leaves free, or nearly so.
///
/// K is looked at scaled to a unit diagonal, so that units and members of unlike stiffness do not matter: an eigenvalue
/// of 1e-9 is a motion a thousand million times softer than its unknowns are by themselves.
struct NullModes {
    /// One column per free motion, its largest entry 1. Independent motions are separated: every mode has an unknown
    /// that no other one moves, and motions of different parts of the structure are different columns.
    Eigen::MatrixXd modes; ///< [unknowns x modes]
    /// False when there are more modes than one would want to hold: then `modes` has some, and nothing else is known.
    bool is_complete = true;
    double smallest_eigenvalue = 0.0; ///< the smallest that is not zero; 0 when all are
    Eigen::VectorXd softest;          ///< its motion, largest entry 1: what is nearly free when nothing is
    double condition = 0.0;           ///< largest over smallest eigenvalue; infinite when there is a free motion

    bool is_singular() const { return modes.cols() > 0; }
};

/// Rank-revealing look at a symmetric positive semidefinite K (lower triangle, any order, zeros on the diagonal
/// allowed), for when a factorization met a pivot that may be rounding alone. Slower than solving: some ten solves.
///
/// Method    inverse iteration on a block of vectors that grows until it holds more than the null space, with Rayleigh
///           quotients of K itself; then elimination with pivoting separates the motions
/// Time      grows with the square of the number of motions; `most` of them end the search, which is not complete then
/// Accuracy  eigenvalues below `zero_tolerance` count as zero; those of a free motion come out near 1e-16
/// Source    [Parlett1998, ch. 14]
NullModes null_modes(const SparseMatrix& K, double zero_tolerance = 1e-14,
                     Eigen::Index most = std::numeric_limits<Eigen::Index>::max() - 1);

/// How the motions of A x = 0 are looked for.
struct NullSearch {
    double zero_tolerance; ///< of eigenvalues of A' A, scaled: less counts as soft
    Eigen::Index most;     ///< motions end the search, which is not complete then
    double largest_entry;  ///< that A has, or had before columns were left out: what is less by 1e-8 may be rounding
};

/// The motions x of A x = 0, looked at in A itself: what K = A' A leaves of a small strain is its square, which
/// rounding hides from null_modes. Of soft motions of K those count that `is_free` says so.
///
/// Method    null_modes of K, each motion corrected by x -= K^-1 A' A x until only rounding is left of A x; then
///           singular values of A among those motions tell the free ones from the soft ones
NullModes null_modes(const Eigen::SparseMatrix<double, Eigen::RowMajor>& A, const NullSearch& search,
                     const std::function<bool(const Eigen::VectorXd&)>& is_free);

/// Estimate of the condition number in the 1-norm of K scaled to a unit diagonal, from a few solves; seldom less than a
/// third of the true number, never more.
/// \pre `solver` holds the factorization of K.
/// Source  [Higham1988]
double condition_estimate(const SymmetricSolver& solver, const SparseMatrix& K);

} // namespace femoop
