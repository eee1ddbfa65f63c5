#include "femoop/analysis/idle_rotation.h"

#include <Eigen/Dense>
#include <algorithm>

namespace femoop {

namespace {

constexpr double idle = 1e-12; // of the stiffness of the members at a node: less is rounding

/// Does a rigid member follow the rotation of its node? Through a rigid joint it does, and through a rigid arm.
bool turns_with_node(const MemberExtras& extras, std::size_t end)
{
    if (extras.has_offset) return true;
    if (extras.is_bar) return false;
    const auto is_rigid = [&](LocalAxis axis) { return extras.joints[end][index(axis)] == rigid_joint; };
    return is_rigid(LocalAxis::rx) || is_rigid(LocalAxis::ry) || is_rigid(LocalAxis::rz);
}

/// Nodes whose rotation some joint may have left idle, with the stiffness that their members have.
std::vector<double> doubtful_nodes(const Structure& structure)
{
    std::vector<double> stiffness(structure.positions.size(), 0.0);
    std::vector<bool> is_doubtful(structure.positions.size(), false);
    std::vector<bool> is_rigid(structure.positions.size(), false);
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const MemberExtras* extras = structure.extras_of(MemberId(i));
        const MemberProperties& p = structure.properties_of(MemberId(i));
        const double L = structure.frame(MemberId(i)).length;
        for (std::size_t end = 0; end < 2; ++end) {
            const NodeId node = structure.members[i].nodes[end];
            double& sum = stiffness[node.index];
            sum = std::max({sum, 4.0 * p.xy.EI / L, 4.0 * p.xz.EI / L});
            if (extras == nullptr) continue;
            if (extras->is_bar || extras->has_flexible_joint) is_doubtful[node.index] = true;
            if (extras->constraint == Constraint::Rigid && turns_with_node(*extras, end)) is_rigid[node.index] = true;
        }
    }
    for (std::size_t i = 0; i < stiffness.size(); ++i)
        if (!is_doubtful[i] || is_rigid[i]) stiffness[i] = 0.0;
    return stiffness;
}

} // namespace

std::vector<HeldRotation> hold_idle_rotations(const Structure& structure, const Equations& equations, SparseMatrix& K)
{
    std::vector<HeldRotation> held;
    const std::span<const Dof> dofs = model_dofs(structure.kind);
    if (is_truss(structure.kind)) return held;
    const std::vector<double> stiffness = doubtful_nodes(structure);
    for (std::size_t node = 0; node < stiffness.size(); ++node) {
        if (stiffness[node] == 0.0) continue;
        HeldRotation rotation{.node = NodeId(node), .rows = {}, .dofs = {}, .direction = {}};
        for (std::size_t i = 0; i < dofs.size(); ++i)
            if (const std::int32_t row = equations.of(NodeId(node), i); index(dofs[i]) >= 3 && row != Equations::none) {
                rotation.rows.push_back(row);
                rotation.dofs.push_back(dofs[i]);
            }
        const auto size = static_cast<Eigen::Index>(rotation.rows.size());
        if (size == 0) continue;
        Eigen::MatrixXd block(size, size);
        for (Eigen::Index i = 0; i < size; ++i)
            for (Eigen::Index j = 0; j < size; ++j) {
                const auto [low, high] = std::minmax(rotation.rows[static_cast<std::size_t>(i)],
                                                     rotation.rows[static_cast<std::size_t>(j)]);
                block(i, j) = K.coeff(high, low);
            }
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(block);
        for (Eigen::Index mode = 0; mode < size; ++mode) {
            if (eigen.eigenvalues()[mode] > idle * stiffness[node]) continue;
            rotation.direction = eigen.eigenvectors().col(mode);
            for (Eigen::Index i = 0; i < size; ++i)
                for (Eigen::Index j = 0; j <= i; ++j) {
                    const auto [low, high] = std::minmax(rotation.rows[static_cast<std::size_t>(i)],
                                                         rotation.rows[static_cast<std::size_t>(j)]);
                    K.coeffRef(high, low) += stiffness[node] * rotation.direction[i] * rotation.direction[j];
                }
            held.push_back(rotation);
        }
    }
    return held;
}

} // namespace femoop
