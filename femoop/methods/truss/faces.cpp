#include "femoop/methods/truss/faces.h"

#include <algorithm>
#include <limits>

#include "femoop/geometry/plane_vectors.h"
#include "femoop/methods/truss/arrangement.h"

namespace femoop::truss {

namespace {

constexpr double touching = 1e-9; // of the lengths at hand
constexpr std::size_t no_face = std::numeric_limits<std::size_t>::max();

struct BarLine {
    Eigen::Vector2d begin, along;
    Eigen::Vector2d at(double share) const { return begin + share * along; }
    /// Where a point lies along it, as a share, if it lies on it between its ends.
    bool passes(const Eigen::Vector2d& point) const
    {
        const Eigen::Vector2d to = point - begin;
        const double share = to.dot(along) / along.squaredNorm();
        return share > touching && share < 1.0 - touching &&
               std::abs(cross_product(along, to)) <= touching * along.squaredNorm();
    }
};

BarLine line_of(const Truss& truss, MemberId bar)
{
    const auto& [a, b] = truss[bar].joints;
    return {truss.joints[a.index], truss.joints[b.index] - truss.joints[a.index]};
}

std::optional<Eigen::Vector2d> crossing_of(const BarLine& a, const BarLine& b)
{
    const double turn = cross_product(a.along, b.along);
    if (std::abs(turn) <= touching * a.along.norm() * b.along.norm()) return std::nullopt;
    const Eigen::Vector2d to = b.begin - a.begin;
    const double on_a = cross_product(to, b.along) / turn, on_b = cross_product(to, a.along) / turn;
    const auto is_inside = [](double share) { return share > touching && share < 1.0 - touching; };
    if (!is_inside(on_a) || !is_inside(on_b)) return std::nullopt;
    return a.at(on_a);
}

std::optional<Refusal> bar_past_joint(const Truss& truss)
{
    for (std::size_t i = 0; i < truss.bars.size(); ++i)
        for (std::size_t j = 0; j < truss.joints.size(); ++j) {
            const MemberId bar(i);
            const NodeId joint(j);
            if (truss.bars_at[j].empty() || std::ranges::find(truss[bar].joints, joint) != truss[bar].joints.end())
                continue;
            if (line_of(truss, bar).passes(truss.joints[j]))
                return Refusal{
                    .kind = RefusalKind::BarPassesJoint, .bars = {bar}, .joints = {joint}, .at = truss.joints[j]};
        }
    return std::nullopt;
}

std::optional<Refusal> bars_that_cross(const Truss& truss)
{
    for (std::size_t i = 0; i < truss.bars.size(); ++i)
        for (std::size_t j = i + 1; j < truss.bars.size(); ++j)
            if (const auto at = crossing_of(line_of(truss, MemberId(i)), line_of(truss, MemberId(j))))
                return Refusal{
                    .kind = RefusalKind::BarsCross, .bars = {MemberId(i), MemberId(j)}, .joints = {}, .at = *at};
    return std::nullopt;
}

std::vector<bool> reached_from(const Truss& truss, NodeId first)
{
    std::vector<bool> is_reached(truss.joints.size(), false);
    std::vector<NodeId> waiting{first};
    is_reached[first.index] = true;
    while (!waiting.empty()) {
        const NodeId joint = waiting.back();
        waiting.pop_back();
        for (const MemberId bar : truss.bars_at[joint.index]) {
            const NodeId other = truss.other_joint(bar, joint);
            if (is_reached[other.index]) continue;
            is_reached[other.index] = true;
            waiting.push_back(other);
        }
    }
    return is_reached;
}

std::optional<Refusal> part_alone(const Truss& truss)
{
    const std::vector<bool> is_reached = reached_from(truss, truss.bars.front().joints[0]);
    Refusal refusal{.kind = RefusalKind::FallsApart};
    for (std::size_t i = 0; i < truss.joints.size(); ++i)
        if (!is_reached[i] && !truss.bars_at[i].empty()) refusal.joints.emplace_back(i);
    return refusal.joints.empty() ? std::nullopt : std::optional(refusal);
}

/// Twice the area to the left of a loop.
double loop_area(const Truss& truss, const std::vector<Way>& loop)
{
    double sum = 0.0;
    for (const Way& way : loop)
        sum += cross_product(truss.joints[begin_of(truss, way).index], truss.joints[end_of(truss, way).index]);
    return sum;
}

} // namespace

NodeId begin_of(const Truss& truss, const Way& way) { return truss[way.bar].joints[way.is_back ? 1 : 0]; }
NodeId end_of(const Truss& truss, const Way& way) { return truss[way.bar].joints[way.is_back ? 0 : 1]; }

std::optional<Refusal> why_not_planar(const Truss& truss)
{
    if (auto refusal = bar_past_joint(truss)) return refusal;
    if (auto refusal = bars_that_cross(truss)) return refusal;
    return part_alone(truss);
}

Faces faces_of(const Truss& truss)
{
    std::vector<std::vector<MemberId>> around;
    for (std::size_t i = 0; i < truss.joints.size(); ++i) around.push_back(clockwise_bars(truss, NodeId(i)));
    const auto next = [&](const Way& way) {
        const NodeId joint = end_of(truss, way);
        const std::vector<MemberId>& bars = around[joint.index];
        const auto at = static_cast<std::size_t>(std::ranges::find(bars, way.bar) - bars.begin());
        const MemberId bar = bars[(at + 1) % bars.size()];
        return Way{bar, truss[bar].joints[1] == joint};
    };
    Faces faces;
    faces.left_of.assign(truss.bars.size(), {no_face, no_face});
    for (std::size_t i = 0; i < 2 * truss.bars.size(); ++i) {
        const Way first{MemberId(i / 2), i % 2 == 1};
        if (faces.left(first) != no_face) continue;
        std::vector<Way> loop;
        Way way = first;
        do {
            faces.left_of[way.bar.index][way.is_back ? 1 : 0] = faces.loops.size();
            loop.push_back(way);
            way = next(way);
        } while (way != first);
        faces.loops.push_back(std::move(loop));
    }
    const auto outer = std::ranges::min_element(faces.loops, {},
                                                [&](const auto& loop) { return loop_area(truss, loop); });
    faces.outer = static_cast<std::size_t>(outer - faces.loops.begin());
    return faces;
}

} // namespace femoop::truss
