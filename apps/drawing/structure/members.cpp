#include "apps/drawing/structure/members.h"

#include "apps/drawing/sketch/symbols.h"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace drawing {

namespace {

ui::Role role_of_member(const Scene& scene, femoop::MemberId id)
{
    if (scene.model[id].rigid) return ui::Role::RigidPart;
    return is_bar(scene.model, id) ? ui::Role::Bar : ui::Role::Member;
}

std::vector<femoop::MemberId> from_back_to_front(const Scene& scene)
{
    std::vector<femoop::MemberId> order(scene.model.members.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = femoop::MemberId{i};
    if (scene.is_flat()) return order;
    std::vector<double> nearness(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        nearness[i] = scene.projection.nearness(scene.shape.members[i].at(0.5 * scene.shape.members[i].length));
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return nearness[a.index] < nearness[b.index]; });
    return order;
}

// In space the gap in the member behind says which one passes in front.
void draw_halo(const Scene& scene, ui::Point a, ui::Point b, double width)
{
    const double length = ui::distance(a, b);
    const double spared = std::min(scene.sketch.px(7.0), 0.3 * length);
    const ui::Point d = ui::direction(b - a);
    scene.sketch.painter().line(a + spared * d, b - spared * d,
                                {.color = scene.sketch.theme().background(), .width = width + scene.sketch.px(5.0)});
}

void draw_arm(const Scene& scene, const Eigen::Vector3d& node, const Eigen::Vector3d& end, const ui::Stroke& stroke)
{
    if (node != end) scene.sketch.line(scene.projection(node), scene.projection(end), stroke);
}

void draw_foundation(const Scene& scene, femoop::MemberId id)
{
    const MemberShape& shape = scene.shape[id];
    Sketch& sketch = scene.sketch;
    const double length = shape.length * scene.projection.scale();
    const int n = std::clamp(static_cast<int>(length / sketch.px(22.0)), 3, 60);
    const SymbolFrame base = scene.frame_on(shape, 0.0);
    const double depth = sketch.px(24.0);
    for (int i = 0; i < n; ++i) {
        const SymbolFrame at = base.moved((i + 0.5) * length / n, -sketch.px(2.0)).turned(-std::numbers::pi / 2);
        draw_zigzag(sketch, at, depth, sketch.px(3.5));
    }
    draw_ground(sketch, base.moved(0.5 * length, -depth - sketch.px(2.0)), 0.5 * length);
    if (!scene.explains()) return;
    const double modulus = *scene.model[id].foundation;
    sketch.caption({.text = "k = " + scene.text(modulus, ui::Measure::FoundationModulus),
                    .role = ui::Role::Spring,
                    .target = base(0.75 * length, -depth - sketch.px(9.0)),
                    .toward = -base.y,
                    .rank = Rank::Minor,
                    .size = sketch.theme().type().small});
}

/// A tapered member as deep as it is, to the structure's scale.
void draw_depths(const Scene& scene, femoop::MemberId id)
{
    const MemberShape& shape = scene.shape[id];
    const std::vector<femoop::Quantity>& depths = scene.model[id].depths;
    const auto half = [&](std::size_t end) {
        return 0.5 * depths[end] * scene.projection.scale() * scene.projection.direction(shape.y());
    };
    const ui::Point a = scene.projection(shape.start), b = scene.projection(shape.end);
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Grid);
    scene.sketch.polygon({a + half(0), b + half(1), b - half(1), a - half(0)},
                         scene.sketch.theme().fill(ui::Role::Support), Clearance::None);
}

void draw_strain_mark(const Scene& scene, femoop::MemberId id)
{
    const femoop::Member& member = scene.model[id];
    std::string mark;
    if (member.rigid) mark = "EI → ∞";
    else if (member.inextensible) mark = "EA → ∞";
    if (member.unshearable && member.theory == femoop::BeamTheory::Timoshenko)
        mark += (mark.empty() ? "" : ", ") + std::string("GA → ∞");
    if (mark.empty() || !scene.explains()) return;
    const MemberShape& shape = scene.shape[id];
    scene.sketch.caption({.text = mark,
                          .role = ui::Role::FaintLabel,
                          .target = scene.projection(shape.at(0.5 * shape.length)),
                          .toward = -scene.projection.direction(shape.y()),
                          .gap = scene.sketch.px(6.0),
                          .rank = Rank::Minor,
                          .size = scene.sketch.theme().type().small});
}

void draw_member(const Scene& scene, femoop::MemberId id, Presence presence)
{
    const MemberShape& shape = scene.shape[id];
    const bool is_subject = presence == Presence::Subject;
    const ui::Stroke stroke = scene.sketch.stroke(is_subject ? role_of_member(scene, id) : ui::Role::Undeformed);
    const ui::Stroke arm = scene.sketch.stroke(is_subject ? ui::Role::RigidPart : ui::Role::Undeformed);
    const ui::Point a = scene.projection(shape.start);
    const ui::Point b = scene.projection(shape.end);
    if (!scene.is_flat() && is_subject) draw_halo(scene, a, b, stroke.width);
    draw_arm(scene, shape.start_node, shape.start, arm);
    draw_arm(scene, shape.end_node, shape.end, arm);
    scene.sketch.line(a, b, stroke);
    if (scene.model[id].depths.size() == 2 && is_subject) draw_depths(scene, id);
    if (scene.model[id].foundation && is_subject) draw_foundation(scene, id);
    if (is_subject) draw_strain_mark(scene, id);
}

void draw_highlight(const Scene& scene, const Highlight& highlight, ui::Role role)
{
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Areas);
    const ui::Stroke stroke = highlight_stroke(scene, role);
    for (const femoop::MemberId id : highlight.members) {
        if (id.index >= scene.shape.members.size()) continue;
        const MemberShape& shape = scene.shape[id];
        scene.sketch.line(scene.projection(shape.start), scene.projection(shape.end), stroke, Clearance::None);
    }
    for (const femoop::NodeId id : highlight.nodes)
        if (id.index < scene.shape.nodes.size())
            scene.sketch.disc(scene.place(id), scene.sketch.px(10.0), stroke.color, Clearance::None);
}

} // namespace

bool is_bar(const femoop::Model& model, femoop::MemberId member)
{
    return femoop::is_truss(model.analysis) || model[member].bar;
}

void draw_members(const Scene& scene, Presence presence)
{
    for (const femoop::MemberId id : from_back_to_front(scene)) draw_member(scene, id, presence);
}

ui::Stroke highlight_stroke(const Scene& scene, ui::Role role)
{
    ui::Stroke stroke = scene.sketch.stroke(role);
    stroke.width *= 2.2;
    stroke.dash = {};
    stroke.color = ui::with_opacity(stroke.color, 0.35);
    return stroke;
}

void draw_highlights(const Scene& scene)
{
    draw_highlight(scene, scene.state.selection, ui::Role::Selection);
    draw_highlight(scene, scene.state.hover, ui::Role::Hover);
}

} // namespace drawing
