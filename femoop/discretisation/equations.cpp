#include "femoop/discretisation/equations.h"

#include <array>
#include <cmath>

#include "femoop/element/analysis_model.h"

namespace femoop {

std::span<const Dof> model_dofs(AnalysisKind kind)
{
    return with_model(kind, [](auto k) { return std::span<const Dof>(AnalysisModel<decltype(k)::value>::global); });
}

namespace {

std::span<const LocalAxis> local_axes(AnalysisKind kind)
{
    return with_model(kind,
                      [](auto k) { return std::span<const LocalAxis>(AnalysisModel<decltype(k)::value>::local); });
}

constexpr std::size_t ends_per_member = 2 * n_local_axes;

bool is_unknown(const Discretisation& structure, NodeId node, Dof dof)
{
    if (!structure.is_attached[node.index]) return false;
    const Discretisation::SupportRow* support = structure.support_of(node);
    return support == nullptr || !support->blocked.contains(dof);
}

/// Which of a member's 12 ends hang on a flexible joint.
std::vector<std::size_t> flexible_joints(const Discretisation& structure, MemberId member)
{
    std::vector<std::size_t> found;
    const MemberEndConditions& end_conditions = *structure.end_conditions_of(member);
    for (std::size_t end = 0; end < 2; ++end)
        for (const LocalAxis axis : local_axes(structure.kind))
            if (std::isfinite(end_conditions.joints[end][index(axis)]))
                found.push_back(end * n_local_axes + index(axis));
    return found;
}

std::vector<std::int32_t> members_with_end_dofs(const Discretisation& structure)
{
    std::vector<std::int32_t> member_end_dofs_of;
    if (!structure.has_constraints) return member_end_dofs_of;
    std::int32_t n = 0;
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const MemberEndConditions* end_conditions = structure.end_conditions_of(MemberId(i));
        const bool has_own = end_conditions != nullptr && end_conditions->constraint != Constraint::None &&
                             !flexible_joints(structure, MemberId(i)).empty();
        member_end_dofs_of.push_back(has_own ? n++ : -1);
    }
    if (n == 0) member_end_dofs_of.clear();
    return member_end_dofs_of;
}

BlockGraph block_graph(const Discretisation& structure, const std::vector<std::int32_t>& member_end_dofs_of)
{
    BlockGraph graph;
    graph.positions = structure.positions;
    const std::span<const Dof> dofs = model_dofs(structure.kind);
    for (std::size_t node = 0; node < structure.positions.size(); ++node) {
        std::int32_t size = 0;
        for (const Dof dof : dofs) size += is_unknown(structure, NodeId(node), dof) ? 1 : 0;
        graph.block_sizes.push_back(size);
    }
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const auto& nodes = structure.members[i].nodes;
        const std::array<std::int32_t, 3> blocks{static_cast<std::int32_t>(nodes[0].index),
                                                 static_cast<std::int32_t>(nodes[1].index),
                                                 static_cast<std::int32_t>(graph.block_sizes.size())};
        const bool has_own = !member_end_dofs_of.empty() && member_end_dofs_of[i] >= 0;
        if (has_own) {
            graph.block_sizes.push_back(static_cast<std::int32_t>(flexible_joints(structure, MemberId(i)).size()));
            graph.positions.push_back(structure.positions[nodes[0].index]);
        }
        graph.add_clique(std::span(blocks).first(has_own ? 3 : 2));
    }
    return graph;
}

} // namespace

BlockGraph block_graph(const Discretisation& structure)
{
    return block_graph(structure, members_with_end_dofs(structure));
}

Equations::Equations(const Discretisation& structure, SolverKind wanted)
    : dofs_per_node_(model_dofs(structure.kind).size()),
      member_end_dofs_of_(members_with_end_dofs(structure)),
      pattern_(block_graph(structure, member_end_dofs_of_), wanted)
{
    const std::span<const Dof> dofs = model_dofs(structure.kind);
    of_node_.assign(structure.positions.size() * dofs.size(), none);
    for (std::size_t node = 0; node < structure.positions.size(); ++node) {
        std::int32_t next = pattern_.first_equation(node);
        for (std::size_t i = 0; i < dofs.size(); ++i)
            if (is_unknown(structure, NodeId(node), dofs[i])) of_node_[node * dofs.size() + i] = next++;
    }
    for (std::size_t i = 0, block = structure.positions.size(); i < member_end_dofs_of_.size(); ++i) {
        if (member_end_dofs_of_[i] < 0) continue;
        std::int32_t next = pattern_.first_equation(block++);
        const std::size_t first = of_member_end_.size();
        of_member_end_.resize(first + ends_per_member, none);
        for (const std::size_t at : flexible_joints(structure, MemberId(i))) of_member_end_[first + at] = next++;
    }
}

std::int32_t Equations::of_member_end(MemberId member, std::size_t end, LocalAxis axis) const
{
    const auto first = static_cast<std::size_t>(member_end_dofs_of_[member.index]) * ends_per_member;
    return of_member_end_[first + end * n_local_axes + index(axis)];
}

} // namespace femoop
