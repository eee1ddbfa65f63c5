#include "femoop/analysis/coupled_members.h"

#include <Eigen/Geometry>

namespace femoop {

namespace {

/// Do releases part this end from its node altogether, as far as displacements go?
bool is_cut(AnalysisKind kind, const MemberEndConditions& end_conditions, std::size_t end)
{
    for (const Dof dof : {Dof::ux, Dof::uy, Dof::uz})
        if (member_dofs(kind).contains(dof) && end_conditions.joints[end][index(dof)] != 0.0) return false;
    return true;
}

/// The axes of a member's end that follow its node: displacements, then rotations.
std::vector<LocalAxis> joined_axes(AnalysisKind kind, const MemberEndConditions* end_conditions, std::size_t end)
{
    std::vector<LocalAxis> axes;
    for (const Dof dof : all_dofs) {
        const bool is_joined = end_conditions == nullptr || end_conditions->joints[end][index(dof)] != 0.0;
        const bool is_bars_rotation = end_conditions != nullptr && end_conditions->is_bar && is_rotation(dof);
        const bool is_spin = dof == Dof::rx && (end_conditions == nullptr || !is_cut(kind, *end_conditions, 1 - end));
        if (is_joined && !is_bars_rotation && !is_spin) axes.push_back(static_cast<LocalAxis>(index(dof)));
    }
    return axes;
}

/// How far the node's unit rotation moves its member's end along one of the member's axes.
double moved(const MemberGeometry& geometry, const Eigen::Vector3d& arm, LocalAxis axis, Dof rotation)
{
    const Eigen::Vector3d turn = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(index(rotation)) - 3);
    const auto row = static_cast<Eigen::Index>(index(axis));
    return row < 3 ? geometry.axes.row(row).dot(turn.cross(arm)) / geometry.length
                   : geometry.axes.row(row - 3).dot(turn);
}

} // namespace

const std::vector<std::vector<MemberId>>& CoupledMembers::members_of_nodes()
{
    if (!members_of_.empty()) return members_of_;
    members_of_.resize(structure_.positions.size());
    for (std::size_t i = 0; i < structure_.members.size(); ++i)
        for (const NodeId node : structure_.members[i].nodes) members_of_[node.index].emplace_back(i);
    return members_of_;
}

Eigen::MatrixXd CoupledMembers::motion(const std::vector<ArtificialRestraint::Part>& parts)
{
    std::vector<Eigen::RowVectorXd> rows;
    const auto add_rows = [&](MemberId member, std::size_t end) {
        const MemberEndConditions* end_conditions = structure_.end_conditions_of(member);
        const MemberGeometry geometry = structure_.geometry(member);
        const Eigen::Vector3d arm = end_conditions == nullptr ? Eigen::Vector3d::Zero() : end_conditions->offsets[end];
        for (const LocalAxis axis : joined_axes(structure_.kind, end_conditions, end)) {
            Eigen::RowVectorXd& row = rows.emplace_back(
                Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(parts.size())));
            for (std::size_t i = 0; i < parts.size(); ++i)
                if (parts[i].node == structure_.members[member.index].nodes[end])
                    row[static_cast<Eigen::Index>(i)] = moved(geometry, arm, axis, parts[i].dof);
        }
    };
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const bool is_listed = i > 0 && parts[i].node == parts[i - 1].node;
        for (const MemberId member : is_listed ? std::vector<MemberId>() : members_of_nodes()[parts[i].node.index])
            for (std::size_t end = 0; end < 2; ++end)
                if (structure_.members[member.index].nodes[end] == parts[i].node) add_rows(member, end);
    }
    Eigen::MatrixXd motion(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(parts.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) motion.row(static_cast<Eigen::Index>(i)) = rows[i];
    return motion;
}

} // namespace femoop
