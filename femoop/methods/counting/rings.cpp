#include "femoop/methods/counting/rings.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "femoop/discretisation/parts.h"
#include "femoop/geometry/plane_vectors.h"

namespace femoop::counting {

namespace {

using Members = std::vector<MemberId>;

constexpr std::size_t most_searched = 2000; // members: of more nobody reads where the rings are

/// The members of a structure in either direction.
struct Step {
    MemberId member;
    bool is_forward = true;
};

NodeId node_before(const Discretisation& structure, Step step)
{
    return structure.members[step.member.index].nodes[step.is_forward ? 0 : 1];
}
NodeId node_after(const Discretisation& structure, Step step)
{
    return structure.members[step.member.index].nodes[step.is_forward ? 1 : 0];
}

using StepsAt = std::vector<std::vector<Step>>; ///< those that leave each node

StepsAt steps_at(const Discretisation& structure)
{
    StepsAt steps(structure.positions.size());
    for (std::size_t i = 0; i < structure.members.size(); ++i)
        for (const bool is_forward : {true, false}) {
            const Step step{MemberId(i), is_forward};
            steps[node_before(structure, step).index].push_back(step);
        }
    return steps;
}

Eigen::Vector2d flat(const Discretisation& structure, NodeId node) { return structure.positions[node.index].head<2>(); }

/// Twice the area that a closed line runs around counter-clockwise.
double twice_area(const std::vector<Eigen::Vector2d>& line)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        sum += cross_product(line[i], line[(i + 1) % line.size()]);
    }
    return sum;
}

Eigen::Vector2d centroid(const std::vector<Eigen::Vector2d>& line)
{
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Eigen::Vector2d a = line[i] - line[0], b = line[(i + 1) % line.size()] - line[0];
        sum += cross_product(a, b) * (a + b);
    }
    return line[0] + sum / (3.0 * twice_area(line));
}

/// Where a horizontal line crosses a closed one, from left to right.
std::vector<double> crossings(const std::vector<Eigen::Vector2d>& line, double y)
{
    std::vector<double> at;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Eigen::Vector2d &a = line[i], &b = line[(i + 1) % line.size()];
        if ((a.y() > y) != (b.y() > y)) at.push_back(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
    }
    std::ranges::sort(at);
    return at;
}

/// The centroid, or on its height the middle of the widest part where it lies outside.
Eigen::Vector2d place_within(const std::vector<Eigen::Vector2d>& line)
{
    const Eigen::Vector2d center = centroid(line);
    const std::vector<double> at = crossings(line, center.y());
    std::pair<double, double> widest{center.x(), center.x()};
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
        if (at[i] < center.x() && center.x() < at[i + 1]) return center;
        if (at[i + 1] - at[i] > widest.second - widest.first) widest = {at[i], at[i + 1]};
    }
    return {0.5 * (widest.first + widest.second), center.y()};
}

/// The meshes of a plane drawing: a walk that always turns left as far as it can runs around one.
class Meshes {
public:
    explicit Meshes(const Discretisation& structure) : structure_(structure), steps_(steps_at(structure))
    {
        for (auto& steps : steps_) std::ranges::sort(steps, {}, [&](Step step) { return angle(step); });
        is_walked_.assign(2 * structure.members.size(), false);
    }

    std::vector<Ring> found()
    {
        std::vector<Ring> meshes;
        for (std::size_t i = 0; i < structure_.members.size(); ++i)
            for (const bool is_forward : {true, false})
                if (auto mesh = mesh_from({MemberId(i), is_forward})) meshes.push_back(std::move(*mesh));
        return meshes;
    }

private:
    double angle(Step step) const
    {
        const Eigen::Vector2d d = flat(structure_, node_after(structure_, step)) -
                                  flat(structure_, node_before(structure_, step));
        return std::atan2(d.y(), d.x());
    }
    std::vector<bool>::reference is_walked(Step step) { return is_walked_[2 * step.member.index + step.is_forward]; }

    /// Of the members at the end of a step the one on its left hand.
    Step left_of(Step step) const
    {
        const auto& steps = steps_[node_after(structure_, step).index];
        const auto back = std::ranges::find_if(
            steps, [&](Step other) { return other.member == step.member && other.is_forward != step.is_forward; });
        return back == steps.begin() ? steps.back() : *std::prev(back);
    }

    /// Nothing where that mesh is known, or is what lies around a part of the structure.
    std::optional<Ring> mesh_from(Step first)
    {
        if (is_walked(first)) return std::nullopt;
        std::vector<Eigen::Vector2d> line;
        Members walked;
        for (Step step = first; !is_walked(step); step = left_of(step)) {
            is_walked(step) = true;
            line.push_back(flat(structure_, node_before(structure_, step)));
            walked.push_back(step.member);
        }
        const double rounding = 1e-12 * structure_.size() * structure_.size();
        if (twice_area(line) <= rounding) return std::nullopt;
        Ring ring{.members = {}, .middle = Eigen::Vector3d::Zero()};
        ring.middle.head<2>() = place_within(line);
        std::ranges::copy_if(walked, std::back_inserter(ring.members),
                             [&](MemberId member) { return std::ranges::count(walked, member) == 1; });
        return ring;
    }

    const Discretisation& structure_;
    StepsAt steps_;
    std::vector<bool> is_walked_;
};

/// Sets of members, of which those are kept that are no sum of others kept.
class IndependentSets {
public:
    bool add(const Members& members)
    {
        std::vector<std::uint32_t> rest;
        for (const MemberId member : members) rest.push_back(member.index);
        std::ranges::sort(rest);
        while (!rest.empty()) {
            const auto [known, is_new] = by_first_.try_emplace(rest.front(), rest);
            if (is_new) return true;
            std::vector<std::uint32_t> sum;
            std::ranges::set_symmetric_difference(rest, known->second, std::back_inserter(sum));
            rest = std::move(sum);
        }
        return false;
    }

private:
    std::map<std::uint32_t, std::vector<std::uint32_t>> by_first_;
};

/// Short rings in any structure.
class ShortRings {
public:
    explicit ShortRings(const Discretisation& structure) : structure_(structure), steps_(steps_at(structure)) {}

    std::vector<Ring> found(std::size_t n_wanted) const
    {
        std::vector<Members> tried;
        if (structure_.members.size() <= most_searched)
            for (std::size_t i = 0; i < structure_.members.size(); ++i) add_ring_through(MemberId(i), tried);
        std::ranges::stable_sort(tried, std::less(), &Members::size);
        add_rings_one_by_one(tried);
        std::vector<Ring> rings;
        IndependentSets known;
        for (Members& members : tried) {
            if (rings.size() == n_wanted) break;
            if (!known.add(members)) continue;
            const Eigen::Vector3d middle = middle_of(members);
            rings.push_back({.members = std::move(members), .middle = middle});
        }
        return rings;
    }

private:
    void add_ring_through(MemberId member, std::vector<Members>& tried) const
    {
        std::vector<bool> may_use(structure_.members.size(), true);
        may_use[member.index] = false;
        add_ring(member, may_use, tried);
    }

    /// Each member closes a ring with those before it, if any: that all of these are independent is sure.
    void add_rings_one_by_one(std::vector<Members>& tried) const
    {
        std::vector<bool> may_use(structure_.members.size(), false);
        for (std::size_t i = 0; i < structure_.members.size(); ++i) {
            add_ring(MemberId(i), may_use, tried);
            may_use[i] = true;
        }
    }

    void add_ring(MemberId member, const std::vector<bool>& may_use, std::vector<Members>& tried) const
    {
        const auto& [start, end] = structure_.members[member.index].nodes;
        std::optional<Members> way = shortest_way(end, start, may_use);
        if (!way) return;
        way->insert(way->begin(), member);
        tried.push_back(std::move(*way));
    }

    std::optional<Members> shortest_way(NodeId from, NodeId to, const std::vector<bool>& may_use) const
    {
        std::map<NodeId, Step> came_by; // each node but the first
        std::deque<NodeId> seen{from};
        while (!seen.empty() && !came_by.contains(to)) {
            const NodeId node = seen.front();
            seen.pop_front();
            for (const Step step : steps_[node.index]) {
                const NodeId next = node_after(structure_, step);
                if (!may_use[step.member.index] || next == from || !came_by.try_emplace(next, step).second) continue;
                seen.push_back(next);
            }
        }
        if (!came_by.contains(to)) return std::nullopt;
        Members way;
        for (NodeId node = to; node != from; node = node_before(structure_, came_by.at(node)))
            way.push_back(came_by.at(node).member);
        std::ranges::reverse(way);
        return way;
    }

    Eigen::Vector3d middle_of(const Members& members) const
    {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const MemberId member : members)
            for (const NodeId node : structure_.members[member.index].nodes) sum += structure_.positions[node.index];
        return sum / (2.0 * static_cast<double>(members.size()));
    }

    const Discretisation& structure_;
    StepsAt steps_;
};

} // namespace

std::vector<Ring> rings(const Discretisation& structure)
{
    const std::size_t n_wanted = structure.members.size() + n_parts(structure) - n_joints(structure);
    std::vector<Ring> rings;
    if (!is_3d(structure.kind)) rings = Meshes(structure).found();
    if (rings.size() != n_wanted) rings = ShortRings(structure).found(n_wanted);
    const double step = 1e-6 * structure.size();
    const auto place = [&](const Ring& ring) {
        const Eigen::Vector3d at = ring.middle / step;
        return std::tuple(std::round(at.z()), std::round(at.y()), std::round(at.x()));
    };
    std::ranges::stable_sort(rings, {}, place);
    return rings;
}

} // namespace femoop::counting
