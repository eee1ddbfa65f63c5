#include "femoop/edit/draw.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

#include "femoop/edit/crossing.h"
#include "femoop/edit/member_line.h"
#include "femoop/edit/naming.h"
#include "femoop/edit/split.h"

namespace femoop {

namespace {

std::optional<NodeId> node_at(const Model& model, const Eigen::Vector3d& place, double nearness)
{
    for (std::size_t i = 0; i < model.nodes.size(); ++i)
        if ((position_of(model, NodeId(i)) - place).norm() <= nearness) return NodeId(i);
    return std::nullopt;
}

/// How far along the line the place lies, if it lies on the line and not at its ends.
std::optional<double> inside(const MemberLine& line, const Eigen::Vector3d& place, double nearness)
{
    const double x = line.direction.dot(place - line.start);
    if (x <= nearness || x >= line.length - nearness) return std::nullopt;
    return (line.at(x) - place).norm() <= nearness ? std::optional(x) : std::nullopt;
}

void cut_if_it_passes(Model& model, MemberId member, NodeId node, double nearness)
{
    const auto& nodes = model[member].nodes;
    if (nodes[0] == node || nodes[1] == node) return;
    const std::optional<double> x = inside(line_of(model, model[member]), position_of(model, node), nearness);
    if (x) split_member(model, member, *x, node);
}

/// Cuts every member that passes the node.
void cut_members_at(Model& model, NodeId node, double nearness)
{
    const std::size_t n_members = model.members.size();
    for (std::size_t i = 0; i < n_members; ++i) cut_if_it_passes(model, MemberId(i), node, nearness);
}

std::vector<MemberId> moved_members(const Model& model, const MovedParts& moved)
{
    std::vector<MemberId> members;
    for (std::size_t i = 0; i < model.members.size(); ++i)
        if (moved.is_moved(model, MemberId(i))) members.emplace_back(i);
    return members;
}

NodeId place_node(Model& model, const Eigen::Vector3d& place, double nearness)
{
    if (const std::optional<NodeId> there = node_at(model, place, nearness)) return *there;
    const double extent = nearness / relative_nearness;
    const NodeId node = model.add(Node{.id = fresh_node_id(model), .at = coordinates(place, extent)});
    cut_members_at(model, node, nearness);
    return node;
}

/// Nodes where the line crosses members.
void place_crossings(Model& model, const MemberLine& line, double nearness)
{
    const std::size_t n_members = model.members.size();
    for (std::size_t i = 0; i < n_members; ++i) {
        const auto place = crossing(line, line_of(model, model.members[i]), nearness);
        if (place) place_node(model, *place, nearness);
    }
}

/// The nodes on the line from its start to its end.
std::vector<NodeId> nodes_along(const Model& model, const MemberLine& line, double nearness)
{
    std::vector<std::pair<double, NodeId>> found;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const Eigen::Vector3d place = position_of(model, NodeId(i));
        const double x = line.direction.dot(place - line.start);
        const bool is_on_line = x >= -nearness && x <= line.length + nearness &&
                                (line.at(x) - place).norm() <= nearness;
        if (is_on_line) found.emplace_back(x, NodeId(i));
    }
    std::ranges::sort(found);
    std::vector<NodeId> nodes;
    for (const auto& [x, node] : found) nodes.push_back(node);
    return nodes;
}

MemberId join(Model& model, NodeId a, NodeId b, const Member& pattern)
{
    if (const std::optional<MemberId> there = member_between(model, a, b)) return *there;
    Member member = pattern;
    member.nodes = {a, b};
    member.id = fresh_member_id(model, a, b);
    return model.add(std::move(member));
}

} // namespace

std::optional<MemberId> member_between(const Model& model, NodeId a, NodeId b)
{
    for (std::size_t i = 0; i < model.members.size(); ++i) {
        const auto& nodes = model.members[i].nodes;
        if ((nodes[0] == a && nodes[1] == b) || (nodes[0] == b && nodes[1] == a)) return MemberId(i);
    }
    return std::nullopt;
}

NodeId place_node(Model& model, const Eigen::Vector3d& place) { return place_node(model, place, nearness_of(model)); }

// While the hand drags, this is done in every frame: what was moved is looked up once, and again after a cut.
void cut_members_at_nodes(Model& model, const MovedParts& moved)
{
    const double nearness = nearness_of(model);
    std::vector<MemberId> moved_now = moved_members(model, moved);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
        const NodeId node(i);
        const std::size_t n_members = model.members.size();
        if (moved.is_moved(model, node)) cut_members_at(model, node, nearness);
        else
            for (const MemberId member : moved_now) cut_if_it_passes(model, member, node, nearness);
        if (model.members.size() != n_members) moved_now = moved_members(model, moved);
    }
}

std::vector<MemberId> draw_member(Model& model, const Eigen::Vector3d& start, const Eigen::Vector3d& end,
                                  const Member& pattern, Crossings crossings)
{
    const Eigen::Vector3d chord = end - start;
    const double nearness = nearness_of(model);
    if (!(chord.norm() > nearness)) throw std::invalid_argument("draw_member: the two ends are at one place");
    const MemberLine line{start, chord.normalized(), chord.norm()};
    place_node(model, start, nearness);
    place_node(model, end, nearness);
    if (crossings == Crossings::Cut) place_crossings(model, line, nearness);
    const std::vector<NodeId> nodes = nodes_along(model, line, nearness);
    for (const NodeId node : nodes) cut_members_at(model, node, nearness);
    std::vector<MemberId> members;
    for (std::size_t i = 1; i < nodes.size(); ++i) members.push_back(join(model, nodes[i - 1], nodes[i], pattern));
    return members;
}

} // namespace femoop
