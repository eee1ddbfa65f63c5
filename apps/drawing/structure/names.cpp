#include "apps/drawing/sketch/symbols.h"
#include "apps/drawing/structure/members.h"

namespace drawing {

namespace {

// Away from the members, on the sheet; up and to the right of a node without any.
ui::Point free_side(const Scene& scene, femoop::NodeId node)
{
    ui::Point sum{};
    for (const femoop::MemberId id : scene.shape.members_at[node.index])
        sum = sum + ui::direction(scene.projection.direction(direction_from(scene.shape, scene.model, node, id)));
    if (ui::length(sum) < 0.2) return {0.6, -0.8};
    const ui::Point away = -ui::direction(sum);
    // Never straight along a member's line, where loads and reactions stand.
    return ui::direction(away + 0.6 * ui::left_normal(away));
}

void name_node(const Scene& scene, femoop::NodeId node)
{
    scene.sketch.caption({.text = scene.model[node].id,
                          .role = ui::Role::Label,
                          .target = scene.place(node),
                          .toward = free_side(scene, node),
                          .gap = scene.sketch.px(6.0),
                          .rank = Rank::Name,
                          .weight = ui::Weight::Bold,
                          .reach = 45.0});
}

void name_member(const Scene& scene, femoop::MemberId id)
{
    const MemberShape& shape = scene.shape[id];
    const auto at = [&](double share) { return scene.projection(shape.at(share * shape.length)); };
    scene.sketch.caption({.text = scene.model[id].id,
                          .role = ui::Role::FaintLabel,
                          .target = at(0.5),
                          .toward = -scene.projection.direction(shape.y()),
                          .gap = 2.5 + 0.5 * scene.sketch.stroke(ui::Role::Member).width,
                          .rank = Rank::Name,
                          .size = scene.sketch.lesser_value_size(),
                          .others = {at(0.4), at(0.6), at(0.3), at(0.7)},
                          .reach = 30.0,
                          .along = scene.projection.direction(shape.x())});
}

void draw_axis(const Scene& scene, const Eigen::Vector3d& origin, const Eigen::Vector3d& axis, const char* name)
{
    const ui::Point from = scene.projection(origin);
    const ui::Point d = scene.projection.direction(axis);
    const ui::Point tip = from + scene.sketch.px(26.0) * d;
    draw(scene.sketch, {.tail = from,
                        .head = tip,
                        .role = ui::Role::LocalAxes,
                        .head_size = 7.0,
                        .facing = axis.dot(scene.projection.toward_eye())});
    scene.sketch.caption({.text = name,
                          .role = ui::Role::LocalAxes,
                          .target = tip,
                          .toward = ui::length(d) > 0.2 ? d : ui::Point{0.7, 0.7},
                          .gap = 2.0,
                          .rank = Rank::Minor,
                          .size = scene.sketch.theme().type().small,
                          .reach = 20.0});
}

} // namespace

void draw_names(const Scene& scene)
{
    if (scene.shows(Show::NodeNames))
        for (std::size_t i = 0; i < scene.model.nodes.size(); ++i) name_node(scene, femoop::NodeId{i});
    if (scene.shows(Show::MemberNames))
        for (std::size_t i = 0; i < scene.model.members.size(); ++i) name_member(scene, femoop::MemberId{i});
}

void draw_local_axes(const Scene& scene)
{
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Symbols);
    for (const MemberShape& shape : scene.shape.members) {
        const Eigen::Vector3d middle = shape.at(0.5 * shape.length);
        draw_axis(scene, middle, shape.x(), "x'");
        draw_axis(scene, middle, shape.y(), "y'");
        if (!scene.is_flat()) draw_axis(scene, middle, shape.z(), "z'");
    }
}

} // namespace drawing
