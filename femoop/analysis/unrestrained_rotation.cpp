#include "femoop/analysis/unrestrained_rotation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "femoop/algebra/symmetric_eigen.h"
#include "femoop/analysis/collinear_torsion.h"
#include "femoop/analysis/coupled_members.h"

#include "femoop/element/analysis_model.h"

namespace femoop {

namespace {

bool may_free_rotations(const MemberEndConditions& end_conditions)
{
    return end_conditions.is_bar || end_conditions.has_flexible_joint;
}

NodeJoints node_joints(const Discretisation& structure)
{
    const std::size_t n = structure.positions.size();
    NodeJoints joints{.stiffness = std::vector<double>(n, 0.0), .is_flexible = std::vector<bool>(n, false)};
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const MemberEndConditions* end_conditions = structure.end_conditions_of(MemberId(i));
        const MemberProperties& p = structure.properties_of(MemberId(i));
        const double L = structure.geometry(MemberId(i)).length;
        for (std::size_t end = 0; end < 2; ++end) {
            const std::size_t node = structure.members[i].nodes[end].index;
            joints.stiffness[node] = std::max({joints.stiffness[node], 4.0 * p.xy.EI / L, 4.0 * p.xz.EI / L});
            if (end_conditions != nullptr && may_free_rotations(*end_conditions)) joints.is_flexible[node] = true;
        }
    }
    return joints;
}

double& entry(SparseMatrix& K, std::int32_t a, std::int32_t b) { return K.coeffRef(std::max(a, b), std::min(a, b)); }

/// The rotations of a node that are unknown.
std::vector<ArtificialRestraint::Part> free_rotations(const Discretisation& structure, const Equations& equations,
                                                      NodeId node)
{
    std::vector<ArtificialRestraint::Part> parts;
    const std::span<const Dof> dofs = model_dofs(structure.kind);
    for (std::size_t i = 0; i < dofs.size(); ++i)
        if (const std::int32_t row = equations.of(node, i); is_rotation(dofs[i]) && row != Equations::none)
            parts.push_back({.node = node, .dof = dofs[i], .row = row});
    return parts;
}

/// The motions of one node that its own block of K does nothing against.
std::vector<ArtificialRestraint> unrestrained_at_node(const std::vector<ArtificialRestraint::Part>& parts,
                                                      double stiffness, SparseMatrix& K)
{
    const auto size = static_cast<Eigen::Index>(parts.size());
    if (size == 0) return {};
    Eigen::MatrixXd block(size, size);
    for (Eigen::Index i = 0; i < size; ++i)
        for (Eigen::Index j = 0; j < size; ++j)
            block(i, j) = entry(K, parts[static_cast<std::size_t>(i)].row, parts[static_cast<std::size_t>(j)].row);
    const SymmetricEigen eigen = symmetric_eigen(block);
    std::vector<ArtificialRestraint> unrestrained;
    for (Eigen::Index mode = 0; mode < size; ++mode)
        if (eigen.values[mode] <= negligible_stiffness * stiffness)
            unrestrained.push_back({.parts = parts, .direction = eigen.vectors.col(mode)});
    return unrestrained;
}

/// Of unrestrained motions of one node those that no member follows: the others are mechanisms.
std::vector<ArtificialRestraint> uncoupled_rotations(std::vector<ArtificialRestraint> unrestrained,
                                                     CoupledMembers& coupled)
{
    if (unrestrained.empty()) return unrestrained;
    const std::vector<ArtificialRestraint::Part> parts = unrestrained.front().parts;
    Eigen::MatrixXd directions(static_cast<Eigen::Index>(parts.size()), static_cast<Eigen::Index>(unrestrained.size()));
    for (std::size_t i = 0; i < unrestrained.size(); ++i)
        directions.col(static_cast<Eigen::Index>(i)) = unrestrained[i].direction;
    const Eigen::MatrixXd moved = coupled.motion(parts) * directions;
    const SymmetricEigen eigen = symmetric_eigen(moved.transpose() * moved);
    std::vector<ArtificialRestraint> still;
    for (Eigen::Index i = 0; i < directions.cols(); ++i)
        if (eigen.values[i] < uncoupled * uncoupled)
            still.push_back({.parts = parts, .direction = directions * eigen.vectors.col(i)});
    return still;
}

} // namespace

std::vector<ArtificialRestraint> restrain_rotations(const Discretisation& structure, const Equations& equations,
                                                    SparseMatrix& K, std::optional<SparseMatrix> resistance)
{
    std::vector<ArtificialRestraint> held;
    if (is_truss(structure.kind) || std::ranges::none_of(structure.end_conditions, may_free_rotations)) return held;
    const NodeJoints joints = node_joints(structure);
    SparseMatrix& resisting = resistance ? *resistance : K;
    NodeJoints measure = joints; // of what resists
    if (resistance)
        std::replace_if(
            measure.stiffness.begin(), measure.stiffness.end(), [](double s) { return s > 0.0; }, 1.0);
    const auto restrain_both = [&](ArtificialRestraint rotation) {
        const std::size_t node = rotation.parts.front().node.index;
        rotation.stiffness = measure.stiffness[node];
        if (resistance) add_restraint(rotation, *resistance);
        rotation.stiffness = joints.stiffness[node];
        add_restraint(rotation, K);
        held.push_back(std::move(rotation));
    };
    CoupledMembers coupled(structure);
    for (std::size_t node = 0; node < measure.stiffness.size(); ++node) {
        if (!measure.may_turn(node)) continue;
        const auto parts = free_rotations(structure, equations, NodeId(node));
        for (const ArtificialRestraint& rotation :
             uncoupled_rotations(unrestrained_at_node(parts, measure.stiffness[node], resisting), coupled))
            restrain_both(rotation);
    }
    for (const ArtificialRestraint& rotation :
         collinear_torsion_mechanisms(structure, equations, measure, coupled, resisting))
        restrain_both(rotation);
    return held;
}

} // namespace femoop
