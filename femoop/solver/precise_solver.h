#pragma once

#include <Eigen/SparseCholesky>
#include <optional>

#include "femoop/solver/double_double.h"
#include "femoop/solver/symmetric_solver.h"

namespace femoop {

/// Solves K X = B where doubles keep too few digits: K, B and X have some 32.
///
/// A factorization in doubles corrects X by its residuals, X += K^-1 (B - K X); where it is so far off that this does
/// not converge, K is factored in 32 digits.
///
/// Accuracy  the strain energy of what X is off is 1e-20 of that of X or less, where `solve` gives an answer
/// Source    [Higham2002, ch. 12]
class PreciseSolver {
public:
    /// `rough` has factored K rounded to doubles; null where it could not. It is used while this lives.
    PreciseSolver(const PreciseSparseMatrix& K, const SymmetricSolver* rough);

    /// Nothing where K is too ill-conditioned, or too large to be factored in 32 digits.
    std::optional<PreciseMatrix> solve(const PreciseMatrix& B);

private:
    struct Factorization : Eigen::SimplicialLDLT<PreciseSparseMatrix> {
        double work() const; ///< multiplications, twice. \pre analyzePattern, and no factorize yet
    };
    bool factorize();
    template <class Correct> std::optional<PreciseMatrix> refined(const PreciseMatrix& B, Correct&& correction) const;

    PreciseSparseMatrix K_;
    const SymmetricSolver* rough_;
    Factorization factorization_;
    std::optional<bool> is_positive_; ///< are all pivots? empty before they were asked for
};

} // namespace femoop
