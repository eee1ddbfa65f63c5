#include "apps/drawing/loads/forces.h"

#include "apps/drawing/loads/loads.h"
#include "apps/drawing/structure/supports.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace drawing {

namespace {

using Eigen::Vector3d;

double force_length(const Scene& scene, double value, double largest)
{
    const double share = largest > 0.0 ? std::abs(value) / largest : 1.0;
    return scene.sketch.px(28.0 + 18.0 * share) * scene.options.load_factor;
}

bool is_occupied(const Scene& scene, femoop::NodeId node, const Vector3d& direction)
{
    const auto& members = scene.shape.members_at[node.index];
    return std::any_of(members.begin(), members.end(), [&](femoop::MemberId id) {
        return direction.dot(direction_from(scene.shape, scene.model, node, id)) > 0.9;
    });
}

} // namespace

void draw_force(const Scene& scene, const ForcePicture& force)
{
    const ui::Point at = scene.projection(force.at);
    const ui::Point d = scene.projection.direction(force.direction);
    const double gap = scene.sketch.px(3.0) + force.gap;
    const bool is_push = force.touches == ArrowAt::Head;
    const ui::Point head = is_push ? at - gap * d : at + (gap + force.length) * d;
    const ui::Point tail = is_push ? at - (gap + force.length) * d : at + gap * d;
    draw(scene.sketch, {.tail = tail,
                        .head = head,
                        .role = force.role,
                        .head_size = 10.0,
                        .facing = force.direction.dot(scene.projection.toward_eye()),
                        .n_heads = force.n_heads});
    std::optional<std::size_t> mark;
    if (force.grip)
        mark = scene.sketch.mark({.load = force.grip->load,
                                  .dof = force.grip->dof,
                                  .area = {tail, head},
                                  .root = is_push ? head : tail,
                                  .tip = is_push ? tail : head});
    if (!scene.shows(Show::Values)) return;
    const ui::Point in_line = ui::length(d) < 0.15 ? ui::Point{0.7, -0.7} : (is_push ? -d : d);
    scene.sketch.caption({.text = force.text,
                          .role = force.role,
                          .target = is_push ? tail : head,
                          .toward = force.text_side.value_or(in_line),
                          .gap = scene.sketch.px(5.0),
                          .rank = Rank::Load,
                          .of = at,
                          .number = force.number,
                          .load_mark = mark});
}

void draw_moment(const Scene& scene, const MomentPicture& moment)
{
    if (!scene.is_flat()) {
        draw_force(scene, {.at = moment.at,
                           .direction = moment.axis,
                           .length = scene.sketch.px(34.0),
                           .touches = ArrowAt::Tail,
                           .gap = scene.sketch.px(4.0),
                           .text = moment.text,
                           .role = moment.role,
                           .n_heads = 2,
                           .grip = moment.grip,
                           .number = moment.number});
        return;
    }
    const SymbolFrame f = scene.projection.frame(moment.at, Vector3d::UnitX(), Vector3d::UnitY());
    const CurvedArrow arrow{.frame = f, .radius = moment.radius, .sense = moment.axis.z(), .role = moment.role};
    draw(scene.sketch, arrow);
    std::optional<std::size_t> mark;
    if (moment.grip)
        mark = scene.sketch.mark({.load = moment.grip->load,
                                  .dof = moment.grip->dof,
                                  .area = area_of(scene.sketch, arrow),
                                  .root = f(0.0, 0.0),
                                  .tip = f(0.0, scene.sketch.px(moment.radius))});
    if (!scene.shows(Show::Values)) return;
    scene.sketch.caption({.text = moment.text,
                          .role = moment.role,
                          .target = f(0.0, 0.0),
                          .toward = moment.text_side,
                          .gap = scene.sketch.px(moment.radius + 5.0),
                          .rank = Rank::Load,
                          .number = moment.number,
                          .load_mark = mark});
}

ui::Point text_side(const Scene& scene, femoop::NodeId node)
{
    double right = 0.0;
    for (const femoop::MemberId id : scene.shape.members_at[node.index])
        right += scene.projection.direction(direction_from(scene.shape, scene.model, node, id)).x;
    return {right > 0.1 ? -0.7 : 0.7, -0.7};
}

ArrowAt free_end(const Scene& scene, femoop::NodeId node, const Vector3d& direction)
{
    const bool behind = is_occupied(scene, node, -direction);
    const bool ahead = is_occupied(scene, node, direction);
    return behind && !ahead ? ArrowAt::Tail : ArrowAt::Head;
}

namespace {

/// Where a load's arrow stands at its node: never over the support's symbol, below which its reaction stands; beside a
/// member that leaves no other side.
struct Stand {
    Vector3d at;
    ArrowAt touches;
};

Stand stand_of(const Scene& scene, femoop::NodeId node, const Vector3d& direction)
{
    constexpr double in_line = 0.7, beside_a_member = 9.0; // [px]
    const Vector3d at = scene.shape[node];
    const ArrowAt free = free_end(scene, node, direction);
    const auto side = support_side_in_model(scene, node);
    const double along = side ? side->dot(direction) : 0.0;
    const ArrowAt clear = along > 0.0 ? ArrowAt::Head : ArrowAt::Tail;
    if (std::abs(along) < in_line || clear == free) return {at, free};
    if (!is_occupied(scene, node, clear == ArrowAt::Head ? Vector3d(-direction) : direction)) return {at, clear};
    const double apart = scene.sketch.px(beside_a_member) / scene.projection.scale();
    return {at + apart * scene.projection.toward_eye().cross(direction).normalized(), clear};
}

} // namespace

namespace {

/// Behind the arrows at a place that are drawn already, and their values. \returns how far
double gap_behind(const Scene& scene, const Vector3d& away, double x, double length, LoadStack& points)
{
    constexpr double room_of_value = 20.0; // [px]
    const double gap = points.height(away, {x, x});
    points.raise(away, {x, x}, gap + length + scene.sketch.px(room_of_value));
    return gap;
}

/// Around the curved arrows at a place that are drawn already. \returns by how many logical pixels
double wider_around(const Vector3d& axis, double x, LoadStack& points)
{
    constexpr double apart = 7.0;
    const double wider = points.height(axis, {x, x});
    points.raise(axis, {x, x}, wider + apart);
    return wider;
}

} // namespace

void draw_node_load(const Scene& scene, const femoop::NodeLoad& load, const LoadScale& scale, LoadStack& points)
{
    for (const femoop::Component& component : load.components) {
        const double value = scale.factor * component.value;
        if (value == 0.0) continue;
        const Vector3d axis = Vector3d::Unit(static_cast<int>(femoop::index(component.dof) % 3));
        const Vector3d direction = value < 0.0 ? Vector3d(-axis) : axis;
        if (femoop::is_rotation(component.dof)) {
            draw_moment(scene, {.at = scene.shape[load.node],
                                .axis = direction,
                                .text = scene.text(std::abs(value), ui::Measure::Moment),
                                .radius = 18.0 + wider_around(direction, 0.0, points),
                                .text_side = text_side(scene, load.node),
                                .grip = GripOf{scale.load, component.dof}});
            continue;
        }
        const Stand stand = stand_of(scene, load.node, direction);
        const double length = force_length(scene, value, scale.largest.force);
        draw_force(scene, {.at = stand.at,
                           .direction = direction,
                           .length = length,
                           .touches = stand.touches,
                           .gap = gap_behind(scene, direction, 0.0, length, points),
                           .text = scene.text(std::abs(value), ui::Measure::Force),
                           .grip = GripOf{scale.load, component.dof}});
    }
}

namespace {

/// Loads on a member's end are drawn just inside it, since they act inside its releases.
double place_of(const Scene& scene, const MemberShape& member, const femoop::LoadComponent& load)
{
    if (load.kind != femoop::LoadComponent::Kind::End) return load.from;
    const double inside = std::min(0.25 * member.length, scene.sketch.px(20.0) / scene.projection.scale());
    return std::clamp(load.from, inside, member.length - inside);
}

} // namespace

void draw_point_load(const Scene& scene, const ShownLoad& shown, const LargestLoads& largest, const LoadStack& stack,
                     LoadStack& points)
{
    const femoop::LoadComponent& load = shown.component;
    if (load.start == 0.0) return;
    const MemberShape& member = scene.shape[shown.member];
    const bool is_on_end = load.kind == femoop::LoadComponent::Kind::End;
    const double x = place_of(scene, member, load);
    const Vector3d direction = (load.start < 0.0 ? -1.0 : 1.0) * femoop::direction_of(load, member);
    const GripOf grip{shown.part, load.dof};
    if (femoop::is_rotation(load.dof))
        return draw_moment(scene, {.at = member.at(x),
                                   .axis = direction,
                                   .text = scene.text(std::abs(load.start), ui::Measure::Moment),
                                   .radius = (is_on_end ? 14.0 : 16.0) + wider_around(direction, x, points),
                                   .grip = grip});
    const double over = is_on_end ? 0.0 : stack.height(-direction, {x, x});
    const double least = over > 0.0 ? over + scene.sketch.px(20.0) : 0.0;
    const double length = std::max(force_length(scene, load.start, largest.force), least);
    draw_force(scene, {.at = member.at(x),
                       .direction = direction,
                       .length = length,
                       .gap = gap_behind(scene, direction, x, length, points),
                       .text = scene.text(std::abs(load.start), ui::Measure::Force),
                       .grip = grip});
}

} // namespace drawing
