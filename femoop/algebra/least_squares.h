#pragma once

#include <Eigen/Core>

namespace femoop {

/// X that makes each column of A X - B as short as it can be, for dense A [rows x n] and B [rows x columns]. Where
/// columns of A depend on one another, the later ones to be chosen as pivots get 0.
/// Method  Householder reflections, the longest column first
Eigen::MatrixXd least_squares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B);

} // namespace femoop
