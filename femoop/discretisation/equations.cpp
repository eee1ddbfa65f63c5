#include "femoop/discretisation/equations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "femoop/element/analysis_model.h"

namespace femoop {

namespace {

constexpr std::size_t ends_per_member = 2 * n_local_axes;

bool is_unknown(const Discretisation& structure, NodeId node, Dof dof)
{
    if (!structure.is_attached[node.index]) return false;
    const Discretisation::SupportRow* support = structure.support_of(node);
    return support == nullptr || !support->blocked.contains(dof);
}

std::vector<std::int32_t> members_with_end_dofs(const Discretisation& structure, const Elements& elements)
{
    std::vector<std::int32_t> index_of;
    if (!structure.has_constraints) return index_of;
    std::int32_t n = 0;
    for (std::size_t i = 0; i < structure.members.size(); ++i)
        index_of.push_back(elements[MemberId(i)].dofs().n_own > 0 ? n++ : -1);
    if (n == 0) index_of.clear();
    return index_of;
}

/// The place of each Dof in the model's order.
std::array<std::size_t, n_dofs> places_of(std::span<const Dof> dofs)
{
    std::array<std::size_t, n_dofs> places{};
    for (std::size_t i = 0; i < dofs.size(); ++i) places[index(dofs[i])] = i;
    return places;
}

using ElementList = std::vector<std::shared_ptr<const Element>>;

/// The same number of displacements of the same nodes, element by element.
bool couple_alike(const ElementList& a, const ElementList& b)
{
    return std::ranges::equal(a, b, [](const auto& first, const auto& second) {
        const ElementDofs p = first->dofs(), q = second->dofs();
        return std::ranges::equal(p.nodes, q.nodes) && std::ranges::equal(p.of_each_node, q.of_each_node) &&
               p.n_own == q.n_own;
    });
}

bool are_tied_alike(const Discretisation& a, const Discretisation& b)
{
    using Tie = Discretisation::Tie;
    return std::ranges::equal(a.ties, b.ties, [](const Tie& p, const Tie& q) {
        return p.node == q.node && p.dof == q.dof && p.leader == q.leader;
    });
}

bool are_blocked_alike(const Discretisation& a, const Discretisation& b, NodeId node)
{
    const auto blocked = [&](const Discretisation& structure) {
        const Discretisation::SupportRow* support = structure.support_of(node);
        return support == nullptr ? DofSet{} : support->blocked;
    };
    return blocked(a) == blocked(b) && a.is_attached[node.index] == b.is_attached[node.index];
}

} // namespace

bool have_same_equations(const Discretisation& a, const Discretisation& b)
{
    if (a.kind != b.kind || a.has_constraints || b.has_constraints) return false;
    if (a.positions.size() != b.positions.size() || a.members.size() != b.members.size()) return false;
    for (std::size_t i = 0; i < a.members.size(); ++i)
        if (a.members[i].nodes != b.members[i].nodes) return false;
    if (!couple_alike(a.bodies, b.bodies) || !couple_alike(a.foundations, b.foundations) || !are_tied_alike(a, b))
        return false;
    for (std::size_t node = 0; node < a.positions.size(); ++node)
        if (!are_blocked_alike(a, b, NodeId(node))) return false;
    return true;
}

namespace {

bool is_tied(const Discretisation& structure, NodeId node, Dof dof)
{
    return std::ranges::any_of(structure.ties,
                               [&](const Discretisation::Tie& tie) { return tie.node == node && tie.dof == dof; });
}

/// The nodes that ties make others follow; empty where there are none.
std::vector<std::vector<NodeId>> leaders_of(const Discretisation& structure)
{
    std::vector<std::vector<NodeId>> leaders(structure.ties.empty() ? 0 : structure.positions.size());
    for (const Discretisation::Tie& tie : structure.ties) leaders[tie.node.index].push_back(tie.leader);
    return leaders;
}

} // namespace

BlockGraph block_graph(const Discretisation& structure, const Elements& elements)
{
    BlockGraph graph;
    graph.positions = structure.positions;
    const std::vector<std::vector<NodeId>> leaders = leaders_of(structure);
    const std::span<const Dof> dofs = model_dofs(structure.kind);
    graph.block_sizes.reserve(structure.positions.size());
    for (std::size_t node = 0; node < structure.positions.size(); ++node) {
        std::int32_t size = 0;
        for (const Dof dof : dofs) size += is_unknown(structure, NodeId(node), dof) ? 1 : 0;
        if (!leaders.empty())
            for (const Dof dof : dofs)
                size -= is_unknown(structure, NodeId(node), dof) && is_tied(structure, NodeId(node), dof) ? 1 : 0;
        graph.block_sizes.push_back(size);
    }
    std::vector<std::int32_t> blocks;
    graph.clique_start.reserve(elements.size() + 1);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const ElementDofs touched = elements[i].dofs();
        blocks.clear();
        for (const NodeId node : touched.nodes) blocks.push_back(static_cast<std::int32_t>(node.index));
        if (!leaders.empty()) {
            for (const NodeId node : touched.nodes)
                for (const NodeId leader : leaders[node.index])
                    blocks.push_back(static_cast<std::int32_t>(leader.index));
            std::ranges::sort(blocks);
            blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
        }
        if (touched.n_own > 0) {
            blocks.push_back(static_cast<std::int32_t>(graph.block_sizes.size()));
            graph.block_sizes.push_back(static_cast<std::int32_t>(touched.n_own));
            graph.positions.push_back(structure.positions[touched.nodes[0].index]);
        }
        graph.add_clique(blocks);
    }
    return graph;
}

Equations::Equations(const Discretisation& structure, const Elements& elements, SolverKind wanted)
    : dofs_per_node_(model_dofs(structure.kind).size()),
      member_end_dofs_of_(members_with_end_dofs(structure, elements)),
      pattern_(block_graph(structure, elements), wanted)
{
    number_nodes(structure);
    number_elements(structure, elements);
    number_member_ends(structure);
}

void Equations::number_nodes(const Discretisation& structure)
{
    const std::span<const Dof> dofs = model_dofs(structure.kind);
    of_node_.assign(structure.positions.size() * dofs.size(), none);
    for (std::size_t node = 0; node < structure.positions.size(); ++node) {
        std::int32_t next = pattern_.first_equation(node);
        for (std::size_t i = 0; i < dofs.size(); ++i)
            if (is_unknown(structure, NodeId(node), dofs[i]) &&
                (structure.ties.empty() || !is_tied(structure, NodeId(node), dofs[i])))
                of_node_[node * dofs.size() + i] = next++;
    }
    for (const Discretisation::Tie& tie : structure.ties) {
        const auto i = static_cast<std::size_t>(std::ranges::find(dofs, tie.dof) - dofs.begin());
        of_node_[tie.node.index * dofs.size() + i] = of_node_[tie.leader.index * dofs.size() + i];
    }
}

void Equations::number_elements(const Discretisation& structure, const Elements& elements)
{
    const std::array<std::size_t, n_dofs> place = places_of(model_dofs(structure.kind));
    std::size_t own_block = structure.positions.size();
    element_start_.reserve(elements.size() + 1);
    element_start_.push_back(0);
    of_elements_.reserve(elements.size() * 2 * dofs_per_node_);
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const ElementDofs touched = elements[i].dofs();
        for (const NodeId node : touched.nodes)
            for (const Dof dof : touched.of_each_node) of_elements_.push_back(of(node, place[index(dof)]));
        if (touched.n_own > 0) {
            const std::int32_t first = pattern_.first_equation(own_block++);
            for (std::size_t own = 0; own < touched.n_own; ++own)
                of_elements_.push_back(first + static_cast<std::int32_t>(own));
        }
        element_start_.push_back(static_cast<std::uint32_t>(of_elements_.size()));
    }
}

void Equations::number_member_ends(const Discretisation& structure)
{
    for (std::size_t i = 0; i < member_end_dofs_of_.size(); ++i) {
        if (member_end_dofs_of_[i] < 0) continue;
        const std::size_t first = of_member_end_.size();
        of_member_end_.resize(first + ends_per_member, none);
        const MemberEndConditions& conditions = *structure.end_conditions_of(MemberId(i));
        std::size_t next = 2 * dofs_per_node_;
        for (std::size_t end = 0; end < 2; ++end)
            for (const LocalAxis axis : member_axes_of(structure.kind))
                if (std::isfinite(conditions.joints[end][index(axis)]))
                    of_member_end_[first + end * n_local_axes + index(axis)] = of_element(i)[next++];
    }
}

std::int32_t Equations::of_member_end(MemberId member, std::size_t end, LocalAxis axis) const
{
    const auto first = static_cast<std::size_t>(member_end_dofs_of_[member.index]) * ends_per_member;
    return of_member_end_[first + end * n_local_axes + index(axis)];
}

} // namespace femoop
