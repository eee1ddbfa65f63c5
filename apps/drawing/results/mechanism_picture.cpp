#include "apps/drawing/results/mechanism_picture.h"

#include "apps/drawing/sketch/symbols.h"

#include <algorithm>
#include <cmath>

namespace drawing {

namespace {

using Eigen::Vector3d;

constexpr double motion_share = 0.14; // of the structure's diagonal, for the largest translation
constexpr double least_motion = 1e-6; // of the largest: less is rounding

Vector3d translation(const femoop::NodeVector& motion) { return {motion[0], motion[1], motion[2]}; }

void draw_node_motion(const Scene& scene, femoop::NodeId node, const femoop::NodeVector& motion, double factor)
{
    Sketch& sketch = scene.sketch;
    const Vector3d moved = factor * translation(motion);
    const ui::Point from = scene.projection(scene.shape[node]);
    const ui::Point to = scene.projection(scene.shape[node] + moved);
    if (ui::distance(from, to) > sketch.px(8.0)) {
        draw(sketch, {.tail = from,
                      .head = to,
                      .role = ui::Role::Mechanism,
                      .head_size = 12.0,
                      .stroke = sketch.thin(ui::Role::Mechanism)});
        return;
    }
    const double turn = motion[5];
    if (scene.is_flat() && std::abs(turn) > 1e-6 && translation(motion).norm() < 1e-6)
        draw(sketch,
             CurvedArrow{.frame = scene.projection.frame(scene.shape[node], Vector3d::UnitX(), Vector3d::UnitY()),
                         .radius = 18.0,
                         .sense = turn,
                         .role = ui::Role::Mechanism});
}

} // namespace

void draw_motion(const Scene& scene, const femoop::Mechanism& mechanism)
{
    const double factor = motion_share * scene.shape.size * scene.state.phase;
    for (std::size_t i = 0; i < scene.shape.members.size() && i < mechanism.member_ends.size(); ++i) {
        const MemberShape& member = scene.shape.members[i];
        const auto& [start, end] = mechanism.member_ends[i];
        const bool rests = start.norm() + end.norm() < least_motion;
        scene.sketch.line(scene.projection(member.start + factor * start), scene.projection(member.end + factor * end),
                          scene.sketch.stroke(rests ? ui::Role::Member : ui::Role::Mechanism));
    }
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Symbols);
    for (std::size_t i = 0; i < scene.shape.nodes.size() && i < mechanism.motion.size(); ++i)
        draw_node_motion(scene, femoop::NodeId{i}, mechanism.motion[i], factor);
}

} // namespace drawing
