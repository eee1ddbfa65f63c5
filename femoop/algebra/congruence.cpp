#include "femoop/algebra/congruence.h"

namespace femoop {

Eigen::MatrixXd congruence(const Eigen::MatrixXd& S, const Eigen::MatrixXd& B)
{
    const Eigen::MatrixXd BS = B.transpose() * S;
    return BS * B;
}

} // namespace femoop
