#include "femoop/element/joint_condensation.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "femoop/algebra/congruence.h"

namespace femoop {

namespace {

constexpr double negligible = 1e-12; // of a column of B: below it only rounding is left

// Symmetric to the last digit: where mirrored entries differ, rigid motions strain, and a long chain is lost.
Eigen::MatrixXd inverse(const Eigen::MatrixXd& A)
{
    const Eigen::MatrixXd rounded = A.llt().solve(Eigen::MatrixXd::Identity(A.rows(), A.cols()));
    return rounded.selfadjointView<Eigen::Lower>();
}

/// Gauss-Jordan elimination of the columns of a few releases: W A = 1 in each one's own row.
struct Reduction {
    Eigen::MatrixXd null_rows;    ///< rows w of W with w A = 0
    Eigen::MatrixXd left_inverse; ///< row by row the columns of A, zero for dependent ones
    Eigen::MatrixXd modes;        ///< A x = 0, one column per dependent one, 1 there
    std::vector<int> dependent;
};

/// The largest entry of a column below `from`.
Eigen::Index pivot_row(const Eigen::MatrixXd& A, Eigen::Index column, Eigen::Index from)
{
    Eigen::Index best = from;
    for (Eigen::Index i = from + 1; i < A.rows(); ++i)
        if (std::abs(A(i, column)) > std::abs(A(best, column))) best = i;
    return best;
}

Reduction reduce(const Eigen::MatrixXd& A)
{
    const Eigen::Index rows = A.rows(), columns = A.cols();
    Eigen::MatrixXd reduced = A;
    Eigen::MatrixXd W = Eigen::MatrixXd::Identity(rows, rows);
    std::vector<Eigen::Index> independent;
    Reduction result;
    for (Eigen::Index j = 0; j < columns; ++j) {
        const auto rank = static_cast<Eigen::Index>(independent.size());
        const Eigen::Index row = rank < rows ? pivot_row(reduced, j, rank) : 0;
        if (rank == rows || std::abs(reduced(row, j)) <= negligible * A.col(j).norm()) {
            result.dependent.push_back(static_cast<int>(j));
            continue;
        }
        reduced.row(rank).swap(reduced.row(row));
        W.row(rank).swap(W.row(row));
        W.row(rank) /= reduced(rank, j);
        reduced.row(rank) /= reduced(rank, j);
        for (Eigen::Index i = 0; i < rows; ++i) {
            if (i == rank) continue;
            W.row(i) -= reduced(i, j) * W.row(rank);
            reduced.row(i) -= (reduced(i, j) * reduced.row(rank)).eval();
        }
        independent.push_back(j);
    }
    const auto rank = static_cast<Eigen::Index>(independent.size());
    result.null_rows = W.bottomRows(rows - rank);
    result.left_inverse = Eigen::MatrixXd::Zero(columns, rows);
    result.left_inverse(independent, Eigen::all) = W.topRows(rank);
    result.modes = Eigen::MatrixXd::Zero(columns, static_cast<Eigen::Index>(result.dependent.size()));
    for (std::size_t i = 0; i < result.dependent.size(); ++i) {
        auto mode = result.modes.col(static_cast<Eigen::Index>(i));
        mode(independent) = -reduced.col(result.dependent[i]).head(rank);
        mode[result.dependent[i]] = 1.0;
    }
    return result;
}

/// What a displacement does to a basis of forces is either something or rounding, which must not hold a mechanism.
void drop_rounding(Eigen::MatrixXd& basis, const Eigen::MatrixXd& B)
{
    for (Eigen::Index j = 0; j < B.cols(); ++j)
        for (Eigen::Index i = 0; i < basis.rows(); ++i)
            if (std::abs(basis(i, j)) <= negligible * B.col(j).norm()) basis(i, j) = 0.0;
}

/// What the dependent ones of some displacements of a member may do without strain.
std::vector<JointCondensation::FreeMotion> motions(const Reduction& reduced, const std::vector<int>& displacements,
                                                   Eigen::Index n)
{
    std::vector<JointCondensation::FreeMotion> found;
    for (std::size_t i = 0; i < reduced.dependent.size(); ++i) {
        JointCondensation::FreeMotion motion{.row = displacements[static_cast<std::size_t>(reduced.dependent[i])],
                                             .mode = Eigen::VectorXd::Zero(n)};
        motion.mode(displacements) = reduced.modes.col(static_cast<Eigen::Index>(i));
        found.push_back(std::move(motion));
    }
    return found;
}

} // namespace

JointCondensation::JointCondensation(const StrainForm& member, const Eigen::VectorXd& joints)
    : B_(member.B), joints_(joints), member_flexibility_(inverse(member.S))
{
    sort();
    const Eigen::MatrixXd at_springs = B_(Eigen::all, sprung_);
    flexibility_ = member_flexibility_ + congruence(spring_flexibility_.asDiagonal(), at_springs.transpose());
    separate_releases();
    separate_strains();
    stiffness_ = inverse(congruence(flexibility_, free_));
}

void JointCondensation::sort()
{
    for (Eigen::Index i = 0; i < joints_.size(); ++i) {
        if (joints_[i] == 0.0) released_.push_back(static_cast<int>(i));
        else if (std::isfinite(joints_[i])) sprung_.push_back(static_cast<int>(i));
    }
    std::sort(sprung_.begin(), sprung_.end(), [&](int a, int b) { return joints_[a] < joints_[b]; });
    spring_flexibility_ = joints_(sprung_).cwiseInverse();
    flexible_ = released_;
    flexible_.insert(flexible_.end(), sprung_.begin(), sprung_.end());
}

void JointCondensation::separate_releases()
{
    const Reduction reduced = reduce(B_(Eigen::all, released_));
    free_ = reduced.null_rows.transpose();
    basis_ = reduced.null_rows * B_;
    basis_(Eigen::all, released_).setZero();
    drop_rounding(basis_, B_);
    follow_ = reduced.left_inverse;
    free_motions_ = motions(reduced, released_, B_.cols());
}

void JointCondensation::separate_strains()
{
    const Reduction reduced = reduce(B_(Eigen::all, flexible_));
    strain_motion_ = reduced.left_inverse;
    rigid_on_springs_ = motions(reduced, flexible_, B_.cols());
    std::erase_if(rigid_on_springs_, [&](const FreeMotion& motion) { return joints_[motion.row] == 0.0; });
}

Eigen::VectorXd JointCondensation::strain_forces(const Eigen::VectorXd& nodes, const Eigen::VectorXd& fixed) const
{
    // What takes the fixed-end forces from the releases, and what then closes the gaps between member and nodes.
    const Eigen::VectorXd released = -follow_.transpose() * fixed(released_);
    const Eigen::VectorXd gaps = B_(Eigen::all, sprung_) * spring_flexibility_.cwiseProduct(fixed(sprung_)) +
                                 flexibility_ * released;
    return released + free_ * (stiffness_ * (basis_ * nodes - free_.transpose() * gaps));
}

Eigen::VectorXd JointCondensation::forces(const Eigen::VectorXd& strain_forces, const Eigen::VectorXd& fixed) const
{
    Eigen::VectorXd p = B_.transpose() * strain_forces + fixed;
    p(released_).setZero();
    return p;
}

Eigen::MatrixXd JointCondensation::stiffness() const { return congruence(stiffness_, basis_); }

Eigen::VectorXd JointCondensation::end_forces(const Eigen::VectorXd& nodes, const Eigen::VectorXd& fixed) const
{
    return forces(strain_forces(nodes, fixed), fixed);
}

Eigen::VectorXd JointCondensation::end_displacements(const Eigen::VectorXd& nodes, const Eigen::VectorXd& fixed) const
{
    // Strains first: they are as exact as the forces. Only what moves without strain is left to the springs.
    const Eigen::VectorXd s = strain_forces(nodes, fixed);
    Eigen::VectorXd ends = nodes;
    ends(flexible_).setZero();
    ends(flexible_) = strain_motion_ * (member_flexibility_ * s - B_ * ends);
    const Eigen::VectorXd p = forces(s, fixed);
    for (const FreeMotion& rigid : rigid_on_springs_)
        ends += (nodes[rigid.row] - p[rigid.row] / joints_[rigid.row]) * rigid.mode;
    return ends;
}

} // namespace femoop
