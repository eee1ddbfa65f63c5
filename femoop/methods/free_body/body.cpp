#include "femoop/methods/free_body/body.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace femoop::free_body {

namespace {

Piece whole(const Discretisation& structure, MemberId member)
{
    return {member, 0.0, structure.geometry(member).length};
}

/// Walks from node to node through members that are not cut, and up to the cuts of the others.
class Flood {
public:
    Flood(const Discretisation& structure, std::span<const Cut> cuts) : structure_(structure)
    {
        members_at_.resize(structure.positions.size());
        for (std::size_t i = 0; i < structure.members.size(); ++i)
            for (const NodeId node : structure.members[i].nodes) members_at_[node.index].emplace_back(i);
        for (const Cut& cut : cuts) cuts_[cut.member].push_back(cut.x);
        for (auto& [member, places] : cuts_) std::ranges::sort(places);
        is_reached_.assign(structure.positions.size(), false);
        is_taken_.assign(structure.members.size(), false);
    }

    Body from(std::span<const NodeId> first)
    {
        for (const NodeId node : first) reach(node);
        for (std::size_t i = 0; i < body_.nodes.size(); ++i)
            for (const MemberId member : members_at_[body_.nodes[i].index]) walk(member, body_.nodes[i]);
        return std::move(body_);
    }

private:
    void reach(NodeId node)
    {
        if (is_reached_[node.index]) return;
        is_reached_[node.index] = true;
        body_.nodes.push_back(node);
    }

    void walk(MemberId member, NodeId from)
    {
        const auto& nodes = structure_.members[member.index].nodes;
        const Piece all = whole(structure_, member);
        const auto cut = cuts_.find(member);
        if (cut == cuts_.end()) {
            if (!is_taken_[member.index]) body_.pieces.push_back(all);
            is_taken_[member.index] = true;
            for (const NodeId node : nodes) reach(node);
            return;
        }
        if (nodes[0] == from)
            body_.pieces.push_back(
                {.member = member, .from = all.from, .to = cut->second.front(), .ends_at_cut = true});
        else
            body_.pieces.push_back({.member = member, .from = cut->second.back(), .to = all.to, .begins_at_cut = true});
    }

    const Discretisation& structure_;
    std::vector<std::vector<MemberId>> members_at_;
    std::map<MemberId, std::vector<double>> cuts_;
    std::vector<bool> is_reached_; ///< of each node
    std::vector<bool> is_taken_;   ///< of each member without a cut
    Body body_;
};

/// Looks for ways from node to node through members that are not cut.
class Ways {
public:
    Ways(const Discretisation& structure, const std::set<MemberId>& cut) : structure_(structure)
    {
        members_at_.resize(structure.positions.size());
        for (std::size_t i = 0; i < structure.members.size(); ++i) {
            if (cut.contains(MemberId(i))) continue;
            for (const NodeId node : structure.members[i].nodes) members_at_[node.index].emplace_back(i);
        }
    }

    /// The members of the shortest one, in their order; none where there is no way.
    std::vector<MemberId> shortest(NodeId from, NodeId to) const
    {
        std::vector<std::optional<MemberId>> reached_over(structure_.positions.size());
        std::vector<NodeId> reached{from};
        for (std::size_t i = 0; i < reached.size() && !reached_over[to.index]; ++i)
            for (const MemberId member : members_at_[reached[i].index]) {
                const NodeId next = other_end(member, reached[i]);
                if (next == from || reached_over[next.index]) continue;
                reached_over[next.index] = member;
                reached.push_back(next);
            }
        std::vector<MemberId> way;
        for (NodeId node = to; reached_over[node.index]; node = other_end(way.back(), node))
            way.push_back(*reached_over[node.index]);
        std::ranges::reverse(way);
        return way;
    }

private:
    NodeId other_end(MemberId member, NodeId end) const
    {
        const auto& nodes = structure_.members[member.index].nodes;
        return nodes[0] == end ? nodes[1] : nodes[0];
    }

    const Discretisation& structure_;
    std::vector<std::vector<MemberId>> members_at_;
};

} // namespace

Body body_of(NodeId node) { return {.nodes = {node}, .pieces = {}}; }

Body body_of(const Discretisation& structure, std::span<const MemberId> members)
{
    Body body;
    std::map<NodeId, int> n_members_at;
    for (const MemberId member : members) {
        body.pieces.push_back(whole(structure, member));
        for (const NodeId node : structure.members[member.index].nodes) ++n_members_at[node];
    }
    for (const auto& [node, n] : n_members_at)
        if (n > 1) body.nodes.push_back(node);
    return body;
}

Body body_of(const Discretisation& structure, std::span<const Cut> cuts, std::span<const NodeId> beside)
{
    return Flood(structure, cuts).from(beside);
}

std::vector<MemberId> members_across(const Discretisation& structure, std::span<const Cut> cuts)
{
    std::set<MemberId> cut_members;
    for (const Cut& cut : cuts)
        if (!cut_members.insert(cut.member).second) return {}; // what lies between two cuts of a member comes off
    const Ways ways(structure, cut_members);
    std::vector<MemberId> shortest;
    for (const MemberId member : cut_members) {
        const auto& nodes = structure.members[member.index].nodes;
        std::vector<MemberId> way = ways.shortest(nodes[0], nodes[1]);
        if (way.empty()) return {};
        if (shortest.empty() || way.size() < shortest.size()) shortest = std::move(way);
    }
    return shortest;
}

} // namespace femoop::free_body
