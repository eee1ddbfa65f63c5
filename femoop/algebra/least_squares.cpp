#include "femoop/algebra/least_squares.h"

#include <Eigen/QR>

namespace femoop {

Eigen::MatrixXd least_squares(const Eigen::MatrixXd& A, const Eigen::MatrixXd& B)
{
    return A.colPivHouseholderQr().solve(B);
}

} // namespace femoop
