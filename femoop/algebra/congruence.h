#pragma once

#include <Eigen/Core>

namespace femoop {

/// B' S B: the stiffness S of strains, or of ends, as it is felt by the displacements that B makes them of.
Eigen::MatrixXd congruence(const Eigen::MatrixXd& S, const Eigen::MatrixXd& B);

} // namespace femoop
