#include "femoop/element/joint_condensation.h"

#include <cmath>

namespace femoop {

namespace {

constexpr double negligible_pivot = 1e-12;     // of a row's own stiffness: below it only rounding is left
constexpr double negligible_stiffness = 1e-13; // of the stiffness with rigid joints, likewise

/// Inverse of a symmetric positive semidefinite matrix over the rows that can be eliminated, largest pivot first
/// (the sweep operator); the rows that cannot are left in `loose`, with zero rows and columns in the inverse.
struct Sweep {
    Eigen::MatrixXd inverse;
    std::vector<int> loose;
    Eigen::MatrixXd follow; ///< how every row moves when a loose one moves by 1
};

Sweep sweep(Eigen::MatrixXd A)
{
    const auto n = A.rows();
    const Eigen::VectorXd scale = A.diagonal();
    std::vector<bool> swept(static_cast<std::size_t>(n), false);
    for (Eigen::Index step = 0; step < n; ++step) {
        Eigen::Index pivot = -1;
        double best = negligible_pivot;
        for (Eigen::Index i = 0; i < n; ++i) {
            const double relative = scale[i] > 0.0 ? A(i, i) / scale[i] : 0.0;
            if (!swept[static_cast<std::size_t>(i)] && relative > best) {
                best = relative;
                pivot = i;
            }
        }
        if (pivot < 0) break;
        swept[static_cast<std::size_t>(pivot)] = true;
        const double d = A(pivot, pivot);
        const Eigen::VectorXd column = A.col(pivot) / d;
        const Eigen::RowVectorXd row = A.row(pivot);
        A -= column * row;
        A.col(pivot) = -column;
        A.row(pivot) = row / d;
        A(pivot, pivot) = 1.0 / d;
    }
    Sweep result{.inverse = Eigen::MatrixXd::Zero(n, n), .loose = {}, .follow = {}};
    for (Eigen::Index j = 0; j < n; ++j)
        if (!swept[static_cast<std::size_t>(j)]) result.loose.push_back(static_cast<int>(j));
    result.follow = Eigen::MatrixXd::Zero(n, static_cast<Eigen::Index>(result.loose.size()));
    for (Eigen::Index i = 0; i < n; ++i) {
        if (!swept[static_cast<std::size_t>(i)]) continue;
        for (Eigen::Index j = 0; j < n; ++j)
            if (swept[static_cast<std::size_t>(j)]) result.inverse(i, j) = A(i, j);
        for (std::size_t l = 0; l < result.loose.size(); ++l)
            result.follow(i, static_cast<Eigen::Index>(l)) = -A(i, result.loose[l]);
    }
    for (std::size_t l = 0; l < result.loose.size(); ++l)
        result.follow(result.loose[l], static_cast<Eigen::Index>(l)) = 1.0;
    return result;
}

} // namespace

JointCondensation::JointCondensation(const Eigen::MatrixXd& k, const Eigen::VectorXd& joints) : k_(k), joints_(joints)
{
    for (Eigen::Index i = 0; i < k.rows(); ++i)
        if (std::isfinite(joints[i])) flexible_.push_back(static_cast<int>(i));
    Eigen::MatrixXd A = k_(flexible_, flexible_);
    A.diagonal() += joints_(flexible_);
    const Sweep swept = sweep(std::move(A));
    inverse_ = swept.inverse;
    for (std::size_t l = 0; l < swept.loose.size(); ++l) {
        Loose loose{.row = flexible_[static_cast<std::size_t>(swept.loose[l])],
                    .mode = Eigen::VectorXd::Zero(k.rows())};
        loose.mode(flexible_) = swept.follow.col(static_cast<Eigen::Index>(l));
        loose_.push_back(std::move(loose));
    }
}

Eigen::VectorXd JointCondensation::end_displacements(const Eigen::VectorXd& nodes, const Eigen::VectorXd& fixed) const
{
    // Equilibrium of the flexible rows: (k + c) d_end = c d_node - k (rigid rows of d_node) - fixed.
    Eigen::VectorXd ends = nodes;
    ends(flexible_).setZero();
    const Eigen::VectorXd force = joints_(flexible_).cwiseProduct(nodes(flexible_)) -
                                  (k_ * ends)(flexible_)-fixed(flexible_);
    ends(flexible_) = inverse_ * force;
    return ends;
}

Eigen::VectorXd JointCondensation::forces(const Eigen::VectorXd& fixed) const
{
    const Eigen::VectorXd ends = end_displacements(Eigen::VectorXd::Zero(k_.rows()), fixed);
    Eigen::VectorXd felt = k_ * ends + fixed;
    felt(flexible_) = -joints_(flexible_).cwiseProduct(ends(flexible_));
    return felt;
}

Eigen::MatrixXd JointCondensation::stiffness() const
{
    const auto n = k_.rows();
    Eigen::MatrixXd K(n, n);
    const Eigen::VectorXd unloaded = Eigen::VectorXd::Zero(n);
    for (Eigen::Index j = 0; j < n; ++j) {
        const Eigen::VectorXd unit = Eigen::VectorXd::Unit(n, j);
        const Eigen::VectorXd ends = end_displacements(unit, unloaded);
        K.col(j) = k_ * ends;
        for (const int row : flexible_) K(row, j) = joints_[row] * (unit[row] - ends[row]);
    }
    K = 0.5 * (K + K.transpose()).eval();
    // A displacement that the releases leave without stiffness must not keep the rounding of its elimination: a
    // mechanism would be held by it.
    for (Eigen::Index j = 0; j < n; ++j) {
        if (std::abs(K(j, j)) > negligible_stiffness * k_(j, j)) continue;
        K.row(j).setZero();
        K.col(j).setZero();
    }
    return K;
}

} // namespace femoop
