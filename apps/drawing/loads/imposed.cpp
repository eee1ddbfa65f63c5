#include "apps/drawing/loads/loads.h"
#include "apps/drawing/sketch/symbols.h"
#include "apps/drawing/structure/plane_supports.h"
#include "apps/drawing/structure/supports.h"

#include <Eigen/Geometry>
#include <cmath>

namespace drawing {

namespace {

using Eigen::Vector3d;

std::string with_sign(const Scene& scene, double value, ui::Measure measure)
{
    return (value > 0.0 ? "+" : "") + scene.text(value, measure);
}

void draw_dashed_line(const Scene& scene, const MemberShape& member, double offset, const std::string& text)
{
    Sketch& sketch = scene.sketch;
    const SymbolFrame f = scene.frame_on(member, 0.0);
    const double length = member.length * scene.projection.scale();
    const double end = std::min(sketch.px(10.0), 0.1 * length);
    sketch.line(f(end, offset), f(length - end, offset), sketch.stroke(ui::Role::Temperature));
    if (!scene.shows(Show::Values)) return;
    const ui::Point outward = offset > 0.0 ? f.y : -f.y;
    sketch.caption({.text = text,
                    .role = ui::Role::Temperature,
                    .target = f(0.5 * length, offset),
                    .toward = outward,
                    .rank = Rank::Load,
                    .others = {f(0.35 * length, offset), f(0.65 * length, offset)},
                    .side = ui::HalfPlane{f.origin, outward}}); // on the other side it would be the other fibre's
}

const ui::DashPattern imposed{4.0, 3.0}; // a displacement, not a force

/// Where the arrow of a settlement begins, and the edge of the support's symbol that a thin line joins it with.
struct ShiftPlace {
    ui::Point edge, tail;
    ui::Point outward; ///< for its value
};

/// Beside the support, clear of the arrows of its reactions: those stand in line with its symbol or with its node.
ShiftPlace place_of_shift(const Scene& scene, femoop::NodeId node, ui::Point d)
{
    Sketch& sketch = scene.sketch;
    const ui::Point side = ui::direction(support_side(scene, node).value_or(ui::Point{0.0, 1.0}));
    const ui::Point base = scene.place(node) + sketch.px(20.0) * side;
    ui::Point across = ui::left_normal(side);
    const bool is_along_symbol = std::abs(ui::dot(d, side)) > std::abs(ui::dot(d, across));
    if (is_along_symbol) {
        if (across.x > 0.1 || across.y > 0.9) across = -across;
        return {base + sketch.px(12.0) * across, base + sketch.px(36.0) * across, across};
    }
    if (ui::dot(d, across) < 0.0) across = -across;
    const ui::Point edge = base + sketch.px(15.0) * across;
    return {edge, edge + sketch.px(16.0) * side, side};
}

void draw_shift(const Scene& scene, femoop::NodeId node, const Vector3d& direction, const std::string& text)
{
    Sketch& sketch = scene.sketch;
    const ui::Point d = scene.projection.direction(direction);
    const auto [edge, tail, outward] = place_of_shift(scene, node, d);
    const ui::Point head = tail + sketch.px(28.0) * d;
    ui::Stroke stroke = sketch.stroke(ui::Role::Load);
    stroke.dash = imposed;
    sketch.line(tail, head - sketch.px(7.0) * ui::direction(d), stroke);
    sketch.line(edge, tail + sketch.px(5.0) * ui::direction(tail - edge), sketch.thin(ui::Role::Load));
    arrow_head(sketch, head, d, sketch.px(9.0), stroke.color);
    if (!scene.shows(Show::Values)) return;
    sketch.caption({.text = text,
                    .role = ui::Role::Load,
                    .target = 0.5 * (tail + head),
                    .toward = outward,
                    .gap = 5.0,
                    .rank = Rank::Load});
}

void draw_turn(const Scene& scene, const Vector3d& node, const Vector3d& axis, const std::string& text)
{
    Sketch& sketch = scene.sketch;
    const Vector3d y = std::abs(axis.z()) > 0.9 ? Vector3d::UnitY() : Vector3d::UnitZ();
    const SymbolFrame f = scene.projection.frame(node, y.cross(axis), y);
    draw(sketch,
         CurvedArrow{.frame = f, .radius = 38.0, .role = ui::Role::Load, .start = 0.7, .sweep = 1.5, .dash = imposed});
    if (!scene.shows(Show::Values)) return;
    sketch.caption({.text = text,
                    .role = ui::Role::Load,
                    .target = f.origin,
                    .toward = {0.5, -0.85},
                    .gap = sketch.px(42.0),
                    .rank = Rank::Load});
}

} // namespace

void draw_temperature(const Scene& scene, femoop::MemberId id, const femoop::TemperatureLoad& load, double factor,
                      LoadStack& stack)
{
    const MemberShape& member = scene.shape[id];
    const double top = factor * load.top;
    const double bottom = factor * load.bottom;
    const double offset = scene.sketch.px(9.0);
    const auto text = [&](double value) { return "ΔT = " + with_sign(scene, value, ui::Measure::Temperature); };
    draw_dashed_line(scene, member, offset, text(top));
    draw_dashed_line(scene, member, -offset, text(bottom));
    stack.raise(member.y(), {0.0, member.length}, offset);
    stack.raise(-member.y(), {0.0, member.length}, offset);
}

void draw_misfit(const Scene& scene, femoop::MemberId id, const femoop::Misfit& misfit, double factor)
{
    const MemberShape& member = scene.shape[id];
    Sketch& sketch = scene.sketch;
    const double elongation = factor * misfit.elongation;
    const double length = member.length * scene.projection.scale();
    const SymbolFrame f = scene.frame_on(member, 0.0);
    const double middle = 0.5 * length;
    const double half = std::min(sketch.px(22.0), 0.3 * length);
    const double at = -sketch.px(9.0);
    // Arrows apart: too long; towards one another: too short.
    for (const double side : {-1.0, 1.0}) {
        const ui::Point inner = f(middle + side * sketch.px(4.0), at);
        const ui::Point outer = f(middle + side * half, at);
        draw(sketch,
             {.tail = elongation > 0.0 ? inner : outer, .head = elongation > 0.0 ? outer : inner, .head_size = 7.0});
    }
    if (!scene.shows(Show::Values)) return;
    sketch.caption({.text = "ΔL = " + with_sign(scene, elongation, ui::Measure::Displacement),
                    .role = ui::Role::Load,
                    .target = f(middle, at - sketch.px(3.0)),
                    .toward = -f.y,
                    .rank = Rank::Load});
}

void draw_settlement(const Scene& scene, const femoop::Settlement& settlement, double factor)
{
    const auto& support = scene.model[settlement.node].support;
    std::array<Vector3d, 3> axes{Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ()};
    if (support && scene.is_flat()) {
        const auto own = plane_support_axes(*support);
        axes = {own[0], own[1], Vector3d::UnitZ()};
    }
    for (const femoop::Component& component : settlement.components) {
        const double value = factor * component.value;
        if (value == 0.0) continue;
        const Vector3d direction = (value < 0.0 ? -1.0 : 1.0) * axes[femoop::index(component.dof) % 3];
        const Vector3d& node = scene.shape[settlement.node];
        if (femoop::is_rotation(component.dof))
            draw_turn(scene, node, direction, "θ = " + scene.text(std::abs(value), ui::Measure::Rotation));
        else
            draw_shift(scene, settlement.node, direction,
                       "δ = " + scene.text(std::abs(value), ui::Measure::Displacement));
    }
}

} // namespace drawing
