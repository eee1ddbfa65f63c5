#pragma once

#include <Eigen/Core>
#include <vector>

namespace femoop {

/// A member's ends joined to its nodes through releases and springs: its own end displacements are eliminated, so
/// that stiffness and forces are those that the nodes feel.
///
///      node o--/\/\--o member's end       spring c:   force = c (d_node - d_end)
///                    c                    release:    c = 0, no force; rigid: d_end = d_node
///
/// Source  static condensation [Przemieniecki1968, sec. 6.6]
class JointCondensation {
public:
    /// `k` is the member's stiffness with rigid joints; `joints` has one stiffness per row of k, infinite for rigid.
    JointCondensation(const Eigen::MatrixXd& k, const Eigen::VectorXd& joints);

    /// Stiffness at the nodes, same size as k.
    Eigen::MatrixXd stiffness() const;

    /// Fixed-end forces at the nodes from those of the member with rigid joints.
    Eigen::VectorXd forces(const Eigen::VectorXd& fixed) const;

    /// The member's own end displacements from those of the nodes and the rigid-joint fixed-end forces.
    Eigen::VectorXd end_displacements(const Eigen::VectorXd& nodes, const Eigen::VectorXd& fixed) const;

    /// A displacement of the member's ends that strains neither member nor joints: its releases leave it loose.
    struct Loose {
        int row;              ///< of k: the displacement that is free
        Eigen::VectorXd mode; ///< the motion of all rows of k
    };
    const std::vector<Loose>& loose() const { return loose_; }

    /// The part of the loads that drives a loose motion: 0 when the loads do no work on it.
    static double drive(const Loose& loose, const Eigen::VectorXd& fixed) { return loose.mode.dot(fixed); }

private:
    Eigen::MatrixXd k_;
    Eigen::VectorXd joints_;
    std::vector<int> flexible_; ///< rows that are not rigid
    Eigen::MatrixXd inverse_;   ///< of k + joints over the flexible rows; zero in loose ones
    std::vector<Loose> loose_;
};

} // namespace femoop
