#include "femoop/methods/influence/usual_path.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

#include "femoop/geometry/member_geometry.h"
#include "femoop/geometry/node_position.h"
#include "femoop/load/place_along.h"
#include "femoop/methods/influence/load_components.h"
#include "femoop/methods/influence/member_motion.h"
#include "femoop/result/components.h"

namespace femoop::influence {

namespace {

using Eigen::Vector3d;

constexpr double straight = 1e-6; // sine of the angle between two members
constexpr double along = 1e-3;    // likewise, between a member and a load that points along it

class Straight {
public:
    explicit Straight(const Model& model) : model_(model), at_node_(model.nodes.size())
    {
        for (std::size_t i = 0; i < model.members.size(); ++i)
            for (const NodeId node : model.members[i].nodes) at_node_[node.index].push_back(MemberId(i));
    }

    std::vector<MemberId> through(MemberId member) const
    {
        const Vector3d x = onward(member);
        std::vector<MemberId> path = going(member, -x);
        std::ranges::reverse(path);
        path.push_back(member);
        std::ranges::copy(going(member, x), std::back_inserter(path));
        return path;
    }

    std::vector<std::vector<MemberId>> all() const
    {
        std::vector<std::vector<MemberId>> paths;
        std::vector<bool> is_passed(model_.members.size(), false);
        for (std::size_t i = 0; i < is_passed.size(); ++i) {
            if (is_passed[i]) continue;
            paths.push_back(through(MemberId(i)));
            for (const MemberId member : paths.back()) is_passed[member.index] = true;
        }
        return paths;
    }

    double length(const std::vector<MemberId>& path) const
    {
        double sum = 0.0;
        for (const MemberId member : path) sum += arm(member).norm();
        return sum;
    }

    /// Whether a load has a part across it, or is a couple.
    bool is_bent(const std::vector<MemberId>& path, const NodeVector& load) const
    {
        if (is_couple(load)) return true;
        const Vector3d force(load[0], load[1], load[2]);
        return onward(path.front()).cross(force).norm() > along * force.norm();
    }

    bool touches(const std::vector<MemberId>& path, NodeId node) const
    {
        return std::ranges::any_of(path, [&](MemberId member) {
            const auto& ends = model_[member].nodes;
            return std::ranges::find(ends, node) != ends.end();
        });
    }

private:
    Vector3d arm(MemberId member) const
    {
        const auto& ends = model_[member].nodes;
        return position_of(model_, ends[1]) - position_of(model_, ends[0]);
    }

    /// The unit vector along it to the right; upright up, and in space along y before that.
    Vector3d onward(MemberId member) const
    {
        Vector3d x = arm(member);
        if (const double length = x.norm(); length > 0.0) x /= length;
        for (const double part : {x.x(), x.y(), x.z()})
            if (std::abs(part) > straight) return part > 0.0 ? x : Vector3d(-x);
        return x;
    }

    /// Those that follow the member in a direction, nearest first. Each lies farther on, so none comes twice.
    std::vector<MemberId> going(MemberId member, const Vector3d& direction) const
    {
        std::vector<MemberId> path;
        for (auto next = next_at(end_towards(member, direction), direction); next;
             next = next_at(end_towards(*next, direction), direction))
            path.push_back(*next);
        return path;
    }

    NodeId end_towards(MemberId member, const Vector3d& direction) const
    {
        return model_[member].nodes[arm(member).dot(direction) > 0.0 ? 1 : 0];
    }

    std::optional<MemberId> next_at(NodeId node, const Vector3d& direction) const
    {
        for (const MemberId member : at_node_[node.index]) {
            const Vector3d away = model_[member].nodes[0] == node ? arm(member) : Vector3d(-arm(member));
            const bool goes_on = away.dot(direction) > 0.0 && away.cross(direction).norm() <= straight * away.norm();
            if (goes_on) return member;
        }
        return std::nullopt;
    }

    const Model& model_;
    std::vector<std::vector<MemberId>> at_node_;
};

bool passes(const Straight& straight, const std::vector<MemberId>& path, const MovingEffect& effect)
{
    if (effect.node) return straight.touches(path, *effect.node);
    return std::ranges::find(path, *effect.member) != path.end();
}

const LoadPath* path_of_file(const Model& model, const Straight& straight, const MovingEffect& effect)
{
    const auto& paths = model.moving_loads.paths;
    const auto found = std::ranges::find_if(
        paths, [&](const LoadPath& path) { return passes(straight, path.members, effect); });
    if (found != paths.end()) return &*found;
    return paths.empty() ? nullptr : &paths.front();
}

} // namespace

std::vector<MemberId> straight_path(const Model& model, MemberId member) { return Straight(model).through(member); }

std::optional<std::vector<MemberId>> row_of(const Model& model, const std::vector<MemberId>& members)
{
    std::vector<std::vector<MemberId>> at_node(model.nodes.size());
    for (const MemberId member : members)
        for (const NodeId node : model[member].nodes) at_node[node.index].push_back(member);
    const auto is_before = [&](NodeId a, NodeId b) {
        const Vector3d p = position_of(model, a), q = position_of(model, b);
        return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
    };
    std::optional<NodeId> place; // the first end, then where the load has come to
    for (std::size_t i = 0; i < at_node.size(); ++i)
        if (at_node[i].size() == 1 && (!place || is_before(NodeId(i), *place))) place = NodeId(i);
    std::vector<MemberId> row;
    while (place && row.size() < members.size()) {
        const std::vector<MemberId>& here = at_node[place->index];
        const bool is_fork = here.size() > 2;
        const auto next = std::ranges::find_if(here,
                                               [&](MemberId member) { return row.empty() || member != row.back(); });
        if (is_fork || next == here.end()) return std::nullopt;
        const auto& ends = model[*next].nodes;
        place = ends[0] == *place ? ends[1] : ends[0];
        row.push_back(*next);
    }
    const bool is_whole = place && at_node[place->index].size() == 1;
    return is_whole && !row.empty() ? std::optional(row) : std::nullopt;
}

std::vector<MemberId> usual_path(const Model& model, const MovingEffect& effect, const NodeVector& load)
{
    const Straight straight(model);
    if (const LoadPath* const path = path_of_file(model, straight, effect)) return path->members;
    const std::vector<std::vector<MemberId>> all = straight.all();
    const auto longest = [&](const auto& is_wanted) {
        const std::vector<MemberId>* best = nullptr;
        constexpr double longer = 1.0 + 1e-9; // of two that are as long the first
        for (const std::vector<MemberId>& path : all)
            if (is_wanted(path) && (best == nullptr || straight.length(path) > longer * straight.length(*best)))
                best = &path;
        return best;
    };
    const auto is_bent = [&](const auto& path) { return straight.is_bent(path, load); };
    const auto is_own = [&](const auto& path) { return is_bent(path) && passes(straight, path, effect); };
    const std::vector<MemberId>* path = is_truss(model.analysis) ? nullptr : longest(is_own);
    if (path == nullptr) path = longest(is_bent);
    return path != nullptr ? *path : all.front();
}

std::vector<MovingEffect> reactions_at(const Model& model, NodeId node)
{
    std::vector<MovingEffect> reactions;
    if (!model[node].support) return reactions;
    const Support& support = *model[node].support;
    for (const Dof dof : dof_list(model.analysis)) {
        const bool is_turned = support.angle.value() != 0.0 && !is_rotation(dof) && dof != Dof::uz;
        const bool is_sprung = std::ranges::any_of(support.springs, [&](const Spring& s) { return s.dof == dof; });
        if (is_turned || is_sprung || support.blocked(model.analysis).contains(dof))
            reactions.push_back({.quantity = ExpectedQuantity::Reaction, .node = node, .dof = dof});
    }
    return reactions;
}

bool is_unheld_reaction(const Model& model, const MovingEffect& effect)
{
    if (effect.quantity != ExpectedQuantity::Reaction) return false;
    const std::vector<MovingEffect> held = reactions_at(model, *effect.node);
    return std::ranges::none_of(held, [&](const MovingEffect& one) { return one.dof == effect.dof; });
}

namespace {

constexpr double square_to = 1e-14; // cosine of a right angle that is rounded

/// Does the node's support leave it no way to move along a direction?
bool is_held_along(const Model& model, NodeId node, const Vector3d& direction)
{
    const std::optional<Support>& support = model[node].support;
    if (!support) return false;
    const DofSet blocked = support->blocked(model.analysis);
    const Eigen::Matrix3d axes = // in its columns
        Eigen::AngleAxisd(support->angle.value() * std::numbers::pi / 180.0, Vector3d::UnitZ()).toRotationMatrix();
    return std::ranges::all_of(std::array{Dof::ux, Dof::uy, Dof::uz}, [&](Dof dof) {
        const bool is_free = dofs(model.analysis).contains(dof) && !blocked.contains(dof);
        return !is_free || std::abs(axes.col(static_cast<Eigen::Index>(index(dof))).dot(direction)) <= square_to;
    });
}

bool is_dof_held(const Model& model, NodeId node, Dof dof)
{
    if (!is_rotation(dof)) return is_held_along(model, node, Vector3d::Unit(static_cast<int>(index(dof))));
    const std::optional<Support>& support = model[node].support;
    return support && support->blocked(model.analysis).contains(dof);
}

/// At an end that neither a joint lets slip nor a rigid arm carries off; of a section between the ends nothing.
std::optional<NodeId> holding_support_of(const Model& model, const Member& member, MemberComponent component,
                                         const Position& at)
{
    const MemberGeometry geometry = geometry_of(model, member);
    const double x = femoop::along(at, geometry.length), near = end_of_member * geometry.length;
    if (x > near && x < geometry.length - near) return std::nullopt;
    const std::size_t which = x > near ? 1 : 0;
    const MemberEnd& end = which == 0 ? member.start : member.end;
    const auto axis = static_cast<std::size_t>(component) - static_cast<std::size_t>(MemberComponent::u);
    const Dof along_axis = all_dofs[axis];
    const bool slips = end.release.contains(along_axis) ||
                       std::ranges::any_of(end.springs, [&](const Spring& s) { return s.dof == along_axis; });
    const NodeId node = member.nodes[which];
    const Vector3d direction = geometry.axes.row(static_cast<Eigen::Index>(axis));
    if (slips || !end.offset.empty() || !is_held_along(model, node, direction)) return std::nullopt;
    return node;
}

} // namespace

std::optional<NodeId> holding_support(const Model& model, const MovingEffect& effect)
{
    if (effect.quantity != ExpectedQuantity::Displacement) return std::nullopt;
    if (effect.member) return holding_support_of(model, model[*effect.member], *effect.component, *effect.at);
    return is_dof_held(model, *effect.node, *effect.dof) ? effect.node : std::nullopt;
}

} // namespace femoop::influence
