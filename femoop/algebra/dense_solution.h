#pragma once

#include <Eigen/Core>

namespace femoop {

/// X of A X = B for dense A [n x n] and B [n x columns], by elimination with row exchanges. Stiffness matrices, which
/// are sparse, go to femoop/solver.
/// \pre A is square and not singular
Eigen::MatrixXd dense_solution(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

Eigen::MatrixXd dense_inverse(const Eigen::MatrixXd& A); ///< the same of B = 1

} // namespace femoop
