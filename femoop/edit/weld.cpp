#include "femoop/edit/weld.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "femoop/edit/draw.h"
#include "femoop/edit/erase.h"
#include "femoop/edit/member_line.h"
#include "femoop/edit/moving_load_change.h"
#include "femoop/edit/reverse.h"

namespace femoop {

namespace {

bool are_at_one_place(const Model& model, NodeId a, NodeId b, double nearness)
{
    return (position_of(model, a) - position_of(model, b)).norm() <= nearness;
}

/// Two that are both known from before met before.
bool have_met(const MovedParts& moved, const Node& a, const Node& b)
{
    const std::optional<NodeId> former_a = moved.former(a), former_b = moved.former(b);
    const Model& before = moved.before();
    return former_a && former_b && are_at_one_place(before, *former_a, *former_b, nearness_of(before));
}

/// Of each node the earliest one at its place, where they have come to meet there. Two that both stayed have not, so
/// the little that moved is compared with all, and what stayed with that alone.
std::vector<NodeId> earliest_at_place(const Model& model, const MovedParts& moved)
{
    const double nearness = nearness_of(model);
    std::vector<NodeId> earliest, earliest_moved;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const NodeId late(i);
        const bool is_moved = moved.is_moved(model, late);
        const auto is_met = [&](NodeId other) {
            return are_at_one_place(model, other, late, nearness) && !have_met(moved, model[other], model[late]);
        };
        const std::vector<NodeId>& others = is_moved ? earliest : earliest_moved;
        const auto found = std::ranges::find_if(others, is_met);
        earliest.push_back(found == others.end() ? late : *found);
        if (is_moved && earliest.back() == late) earliest_moved.push_back(late);
    }
    return earliest;
}

void adopt(Node& kept, const Node& dropped)
{
    if (!kept.support) kept.support = dropped.support;
    kept.hinge = kept.hinge || dropped.hinge;
    kept.mass.insert(kept.mass.end(), dropped.mass.begin(), dropped.mass.end());
}

void refer_to_earliest(Model& model, const std::vector<NodeId>& earliest)
{
    const auto refer = [&](NodeId& node) { node = earliest[node.index]; };
    for (Member& member : model.members) std::ranges::for_each(member.nodes, refer);
    for (LoadCase& load_case : model.load_cases) {
        for (NodeLoad& load : load_case.nodes) refer(load.node);
        std::erase_if(load_case.settlements, [&](const Settlement& late) {
            const NodeId kept = earliest[late.node.index];
            return kept != late.node && std::ranges::count(load_case.settlements, kept, &Settlement::node) > 0;
        });
        for (Settlement& settlement : load_case.settlements) refer(settlement.node);
    }
    for (Expected& check : model.expected)
        if (check.node) refer(*check.node);
    for (InfluenceLineDefinition& line : model.moving_loads.influence_lines)
        if (line.effect.node) refer(*line.effect.node);
}

void weld_nodes(Model& model, const MovedParts& moved)
{
    const std::vector<NodeId> earliest = earliest_at_place(model, moved);
    Parts gone;
    for (std::size_t i = 0; i < earliest.size(); ++i) {
        if (earliest[i] == NodeId(i)) continue;
        adopt(model.nodes[earliest[i].index], model.nodes[i]);
        gone.nodes.emplace_back(i);
    }
    if (gone.nodes.empty()) return;
    refer_to_earliest(model, earliest);
    for (std::size_t i = 0; i < model.members.size(); ++i)
        if (model.members[i].nodes[0] == model.members[i].nodes[1]) gone.members.emplace_back(i);
    erase(model, gone);
}

/// The loads of a member go to its twin, which has the same direction.
void hand_over_loads(Model& model, MemberId from, MemberId to)
{
    for (LoadCase& load_case : model.load_cases)
        for (MemberLoad& load : load_case.members)
            if (load.member == from) load.member = to;
    change_paths(model, [&](std::vector<MemberId>& path) { std::ranges::replace(path, from, to); });
}

bool have_met(const MovedParts& moved, const Member& a, const Member& b)
{
    const std::optional<MemberId> former_a = moved.former(a), former_b = moved.former(b);
    if (!former_a || !former_b) return false;
    const Member &then_a = moved.before()[*former_a], &then_b = moved.before()[*former_b];
    return std::ranges::is_permutation(then_a.nodes, then_b.nodes);
}

void weld_members(Model& model, const MovedParts& moved)
{
    std::map<std::pair<NodeId, NodeId>, MemberId> between;
    Parts gone;
    for (std::size_t i = 0; i < model.members.size(); ++i) {
        const MemberId late(i);
        const auto [low, high] = std::minmax(model[late].nodes[0], model[late].nodes[1]);
        const auto [found, is_first] = between.try_emplace({low, high}, late);
        if (is_first || have_met(moved, model[found->second], model[late])) continue;
        if (model[found->second].nodes != model[late].nodes) reverse_member(model, late);
        hand_over_loads(model, late, found->second);
        gone.members.push_back(late);
    }
    if (!gone.members.empty()) erase(model, gone);
}

} // namespace

void weld(Model& model, const Model& before, const Welding& welding)
{
    const MovedParts moved(before);
    if (welding.crossings == Crossings::Cut)
        for (const Eigen::Vector3d& place : new_crossings(model, moved, welding.n_copies)) place_node(model, place);
    weld_nodes(model, moved);
    cut_members_at_nodes(model, moved);
    weld_members(model, moved);
}

void weld(Model& model) { weld(model, {}); }

} // namespace femoop
