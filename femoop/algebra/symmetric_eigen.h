#pragma once

#include <Eigen/Core>

namespace femoop {

/// A = V diag(l) V', V' V = 1.
struct SymmetricEigen {
    Eigen::VectorXd values;  ///< l, the least first
    Eigen::MatrixXd vectors; ///< V, a column each
};

/// Of a symmetric matrix, whose lower triangle is read. Compiled once for all who ask: what Eigen makes of it in each
/// source takes longer than the source.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A);

} // namespace femoop
