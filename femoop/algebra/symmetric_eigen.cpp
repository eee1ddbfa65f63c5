#include "femoop/algebra/symmetric_eigen.h"

#include <Eigen/Eigenvalues>

namespace femoop {

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& A)
{
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(A);
    return {.values = eigen.eigenvalues(), .vectors = eigen.eigenvectors()};
}

} // namespace femoop
