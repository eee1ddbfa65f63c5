#include "apps/drawing/structure/support_side.h"

#include <algorithm>
#include <cmath>

namespace drawing {

namespace {

// 1 where a member runs straight that way, -1 where all run the other way.
double occupation(const Scene& scene, femoop::NodeId node, const Eigen::Vector3d& direction)
{
    const auto& members = scene.shape.members_at[node.index];
    if (members.empty()) return 0.0;
    double most = -1.0;
    for (const femoop::MemberId id : members)
        most = std::max(most, direction.dot(direction_from(scene.shape, scene.model, node, id)));
    return most;
}

} // namespace

Eigen::Vector3d least_occupied(const Scene& scene, femoop::NodeId node, std::span<const SideChoice> choices,
                               double room_enough)
{
    const auto cost = [&](const SideChoice& choice) {
        return std::max(room_enough, occupation(scene, node, choice.direction)) + choice.strangeness;
    };
    return std::min_element(choices.begin(), choices.end(),
                            [&](const SideChoice& a, const SideChoice& b) { return cost(a) < cost(b) - 1e-9; })
        ->direction;
}

void mark_support(const Scene& scene, femoop::NodeId node, const Eigen::Vector3d& side, double length)
{
    const ui::Point root = scene.place(node);
    const ui::Point half = (0.5 * length) * scene.projection.direction(side);
    scene.sketch.mark({.node = node, .root = root, .middle = root + half, .radius = std::hypot(half.x, half.y)});
}

} // namespace drawing
