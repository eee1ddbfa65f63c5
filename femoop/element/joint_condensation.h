#pragma once

#include <Eigen/Core>
#include <vector>

#include "femoop/element/strain_form.h"

namespace femoop {

/// A member's ends joined to its nodes through releases and springs: its own end displacements are eliminated, so
/// that stiffness and forces are those that the nodes feel.
///
///      node o--/\/\--o member's end       spring c:   force = c (d_node - d_end)
///                    c                    release:    c = 0, no force; rigid: d_end = d_node
///
/// Springs and member are in series, so that flexibilities add: e = (1/S + B 1/c B') s, of forces s that leave the
/// releases without force. Nothing is subtracted, and a spring far softer than its member keeps its digits.
///
/// Source  flexibilities in series [Przemieniecki1968, sec. 6.6]
class JointCondensation {
public:
    /// `joints` has one stiffness per displacement of the member, infinite for rigid.
    JointCondensation(const StrainForm& member, const Eigen::VectorXd& joints);

    /// Stiffness at the nodes, and what makes it: B is zero for what strains nothing once the releases have followed.
    Eigen::MatrixXd stiffness() const;
    StrainForm strain_form() const { return {.B = basis_, .S = stiffness_}; }

    /// Forces on the member's ends, which its nodes feel, from displacements of the nodes and rigid-joint fixed-end
    /// forces.
    Eigen::VectorXd end_forces(const Eigen::VectorXd& nodes, const Eigen::VectorXd& fixed) const;

    /// The member's own end displacements from the same.
    Eigen::VectorXd end_displacements(const Eigen::VectorXd& nodes, const Eigen::VectorXd& fixed) const;

    /// A displacement of the member's ends that strains neither member nor joints: its releases leave it free.
    struct FreeMotion {
        int row;              ///< the displacement that is free
        Eigen::VectorXd mode; ///< the motion of all displacements
    };
    const std::vector<FreeMotion>& free_motions() const { return free_motions_; }

    /// The work of the loads on such a motion.
    static double work(const FreeMotion& motion, const Eigen::VectorXd& fixed) { return motion.mode.dot(fixed); }

private:
    void sort();
    void separate_releases();
    void separate_strains();
    Eigen::VectorXd strain_forces(const Eigen::VectorXd& nodes, const Eigen::VectorXd& fixed) const;
    Eigen::VectorXd forces(const Eigen::VectorXd& strain_forces, const Eigen::VectorXd& fixed) const;

    Eigen::MatrixXd B_;
    Eigen::VectorXd joints_;
    std::vector<int> released_, sprung_; ///< displacements; of the springs the softest first
    std::vector<int> flexible_;          ///< both, one after the other
    Eigen::VectorXd spring_flexibility_; ///< parallel to sprung_
    Eigen::MatrixXd member_flexibility_; ///< 1/S
    Eigen::MatrixXd flexibility_;        ///< of member and springs in series
    Eigen::MatrixXd free_;               ///< a basis of the forces s that leave releases without force [strains x free]
    Eigen::MatrixXd basis_;              ///< how far each displacement works on that basis [free x displacements]
    Eigen::MatrixXd stiffness_;          ///< of that basis, through the springs
    Eigen::MatrixXd follow_;             ///< of releases per strain: a left inverse of B there
    Eigen::MatrixXd strain_motion_;      ///< of flexible joints per strain: a left inverse of B there
    std::vector<FreeMotion> free_motions_;
    std::vector<FreeMotion> rigid_on_springs_; ///< motions of the member that strain its springs only
};

} // namespace femoop
