#include "femoop/methods/funicular/chain.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace femoop::funicular {

namespace {

using Eigen::Vector2d;

constexpr double hardly_any = 1e-9; // of a length

/// How far a member goes to the right from its first node to its second; nothing where it stands upright or turns back.
std::optional<double> way_right(const Discretisation& structure, MemberId member)
{
    const auto& nodes = structure.members[member.index].nodes;
    const Vector2d between = (structure.positions[nodes[1].index] - structure.positions[nodes[0].index]).head<2>();
    const MemberGeometry geometry = structure.geometry(member);
    const Vector2d along = (geometry.end - geometry.start).head<2>();
    const bool runs = std::abs(between.x()) > hardly_any * between.norm() &&
                      std::abs(along.x()) > hardly_any * along.norm() && between.x() * along.x() > 0.0;
    return runs ? std::optional(between.x()) : std::nullopt;
}

NodeId node_at(const Discretisation& structure, const Chain::Link& link, bool at_left)
{
    return structure.members[link.member.index].nodes[at_left == link.is_reversed ? 1 : 0];
}

Chain::Link link_of(const Discretisation& structure, MemberId member)
{
    return {member, way_right(structure, member).value_or(0.0) < 0.0};
}

/// Members by the node at their left, or at their right.
using ByNode = std::map<std::size_t, MemberId>;

ByNode by_node(const Discretisation& structure, std::span<const MemberId> members, bool at_left)
{
    ByNode found;
    for (const MemberId member : members)
        found.emplace(node_at(structure, link_of(structure, member), at_left).index, member);
    return found;
}

std::optional<Refusal> fork(const Discretisation& structure, std::span<const MemberId> members, bool at_left)
{
    const ByNode first = by_node(structure, members, at_left);
    for (const MemberId member : members) {
        const NodeId node = node_at(structure, link_of(structure, member), at_left);
        const MemberId other = first.at(node.index);
        if (other != member) return Refusal{.kind = RefusalKind::Fork, .members = {other, member}, .nodes = {node}};
    }
    return std::nullopt;
}

/// Those that no other leads to.
std::vector<MemberId> leftmost(const Discretisation& structure, std::span<const MemberId> members)
{
    const ByNode by_right = by_node(structure, members, false);
    std::vector<MemberId> found;
    for (const MemberId member : members)
        if (!by_right.contains(node_at(structure, link_of(structure, member), true).index)) found.push_back(member);
    return found;
}

double joint(const Discretisation& structure, const Chain::Link& link, bool at_left)
{
    const MemberEndConditions* const ends = structure.end_conditions_of(link.member);
    return ends == nullptr ? rigid_joint : ends->joints[at_left == link.is_reversed ? 1 : 0][index(LocalAxis::rz)];
}

Vector2d end_of(const Discretisation& structure, const Chain::Link& link, bool at_left)
{
    const MemberGeometry geometry = structure.geometry(link.member);
    return (at_left == link.is_reversed ? geometry.end : geometry.start).head<2>();
}

std::vector<Vector2d> hinges_between(const Discretisation& structure, const Chain& chain)
{
    std::vector<Vector2d> found;
    for (std::size_t i = 0; i < chain.links.size(); ++i) {
        if (i > 0 && joint(structure, chain.links[i], true) == 0.0)
            found.push_back(end_of(structure, chain.links[i], true));
        if (i + 1 < chain.links.size() && joint(structure, chain.links[i], false) == 0.0)
            found.push_back(end_of(structure, chain.links[i], false));
    }
    const auto same = [&](const Vector2d& a, const Vector2d& b) { return (a - b).norm() <= hardly_any * chain.span(); };
    found.erase(std::unique(found.begin(), found.end(), same), found.end());
    return found;
}

bool is_pinned(const Discretisation& structure, NodeId node, double joint)
{
    const Discretisation::SupportRow* const support = structure.support_of(node);
    if (support == nullptr) return false;
    const bool turns = joint == 0.0 || (!support->blocked.contains(Dof::rz) && support->springs[index(Dof::rz)] == 0.0);
    return turns && support->blocked.contains(Dof::ux) && support->blocked.contains(Dof::uy);
}

bool is_three_hinged_arch(const Discretisation& structure, const Chain& chain)
{
    const auto stands_free = [&](const Chain::Link& link) {
        const MemberEndConditions* const ends = structure.end_conditions_of(link.member);
        return (ends == nullptr || !ends->has_offset) && structure.properties_of(link.member).xy.foundation == 0.0;
    };
    return chain.hinge && structure.members.size() == chain.links.size() && structure.supports.size() == 2 &&
           is_pinned(structure, chain.nodes.front(), joint(structure, chain.links.front(), true)) &&
           is_pinned(structure, chain.nodes.back(), joint(structure, chain.links.back(), false)) &&
           std::ranges::all_of(chain.links, stands_free);
}

std::vector<NodeId> held_between(const Discretisation& structure, const Chain& chain)
{
    std::vector<int> n_members(structure.positions.size());
    for (const auto& member : structure.members)
        for (const NodeId node : member.nodes) ++n_members[node.index];
    std::vector<NodeId> found;
    for (std::size_t i = 1; i + 1 < chain.nodes.size(); ++i) {
        const NodeId node = chain.nodes[i];
        if (n_members[node.index] > 2 || structure.support_of(node) != nullptr) found.push_back(node);
    }
    return found;
}

double on_line(const Vector2d& a, const Vector2d& b, double x)
{
    return std::lerp(a.y(), b.y(), (x - a.x()) / (b.x() - a.x()));
}

} // namespace

double Chain::height(double x) const
{
    const auto beyond = std::ranges::upper_bound(axis, x, {}, [](const Vector2d& place) { return place.x(); });
    if (beyond == axis.begin()) return axis.front().y();
    if (beyond == axis.end()) return axis.back().y();
    return on_line(*(beyond - 1), *beyond, x);
}

double Chain::chord(double x) const { return on_line(left(), right(), x); }

std::optional<Vector2d> Chain::crown() const
{
    if (hinge) return hinge;
    const auto off = [&](const Vector2d& place) { return std::abs(place.y() - chord(place.x())); };
    const auto farthest = std::ranges::max_element(axis, {}, off);
    if (off(*farthest) <= hardly_any * span()) return std::nullopt;
    return *farthest;
}

std::vector<MemberId> members_across(const Discretisation& structure)
{
    std::vector<MemberId> found;
    for (std::size_t i = 0; i < structure.members.size(); ++i)
        if (way_right(structure, MemberId(i))) found.emplace_back(i);
    return found;
}

std::optional<Refusal> why_no_chain(const Discretisation& structure, std::span<const MemberId> members)
{
    if (structure.kind != AnalysisKind::Frame2d) return Refusal{.kind = RefusalKind::NotPlaneFrame};
    if (members.empty()) return Refusal{.kind = RefusalKind::NoMember};
    for (const MemberId member : members)
        if (!way_right(structure, member)) return Refusal{.kind = RefusalKind::Upright, .members = {member}};
    for (const bool at_left : {true, false})
        if (auto found = fork(structure, members, at_left)) return found;
    const std::vector<MemberId> first = leftmost(structure, members);
    if (first.size() > 1) return Refusal{.kind = RefusalKind::Apart, .members = {first[0], first[1]}};
    return std::nullopt;
}

Chain chain_of(const Discretisation& structure, std::span<const MemberId> members)
{
    const ByNode by_left = by_node(structure, members, true);
    const auto place = [&](NodeId node) { return Vector2d(structure.positions[node.index].head<2>()); };
    Chain chain;
    std::optional<MemberId> next = leftmost(structure, members).front();
    while (next) {
        const Chain::Link link = link_of(structure, *next);
        const NodeId from = node_at(structure, link, true), to = node_at(structure, link, false);
        if (chain.links.empty()) {
            chain.nodes = {from};
            chain.axis = {place(from)};
        }
        chain.links.push_back(link);
        chain.nodes.push_back(to);
        for (const Vector2d& point : {end_of(structure, link, true), end_of(structure, link, false), place(to)})
            if (point != chain.axis.back()) chain.axis.push_back(point);
        const auto after = by_left.find(to.index);
        next = after == by_left.end() ? std::nullopt : std::optional(after->second);
    }
    const std::vector<Vector2d> hinges = hinges_between(structure, chain);
    if (hinges.size() == 1) chain.hinge = hinges.front();
    chain.held = held_between(structure, chain);
    chain.is_three_hinged_arch = is_three_hinged_arch(structure, chain);
    return chain;
}

} // namespace femoop::funicular
