#include "femoop/algebra/dense_solution.h"

#include <Eigen/LU>

namespace femoop {

Eigen::MatrixXd dense_solution(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B) { return A.partialPivLu().solve(B); }

Eigen::MatrixXd dense_inverse(const Eigen::MatrixXd& A)
{
    return dense_solution(A, Eigen::MatrixXd::Identity(A.rows(), A.cols()));
}

} // namespace femoop
