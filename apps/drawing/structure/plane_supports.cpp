#include "apps/drawing/structure/plane_supports.h"

#include "apps/drawing/sketch/symbols.h"
#include "apps/drawing/structure/support_side.h"
#include "apps/drawing/structure/support_symbol.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace drawing {

namespace {

using Eigen::Vector3d;
using femoop::Dof;

using std::numbers::pi;

std::vector<SideChoice> choices_for(SupportSymbol symbol, const std::array<Vector3d, 2>& axes)
{
    const Vector3d& x = axes[0];
    const Vector3d& y = axes[1];
    switch (symbol) {
    case SupportSymbol::Wall: return {{-y, 0.0}, {-x, 0.0}, {x, 0.0}, {y, 0.05}};
    case SupportSymbol::Pin: return {{-y, 0.0}, {-x, 0.45}, {x, 0.45}, {y, 0.55}};
    case SupportSymbol::RollerX:
    case SupportSymbol::SliderX: return {{-x, 0.0}, {x, 0.0}};
    default: break;
    }
    return {{-y, 0.0}, {y, 0.5}};
}

/// A frame at the node whose y points out of the ground towards the node.
SymbolFrame standing(const Scene& scene, femoop::NodeId node, const Vector3d& side)
{
    const Vector3d up = -side;
    return scene.projection.frame(scene.shape[node], {up.y(), -up.x(), 0.0}, up);
}

void draw_spring(const Scene& scene, femoop::NodeId node, const femoop::Spring& spring,
                 const std::array<Vector3d, 2>& axes)
{
    Sketch& sketch = scene.sketch;
    const bool turns = spring.dof == Dof::rz;
    const Vector3d& axis = spring.dof == Dof::ux ? axes[0] : axes[1];
    const std::array<SideChoice, 2> sides{{{-axis, 0.0}, {axis, spring.dof == Dof::ux ? 0.0 : 0.5}}};
    const Vector3d side = turns ? axes[0] : least_occupied(scene, node, sides);
    const double length = sketch.px(turns ? 15.0 : 38.0);
    const SymbolFrame f = scene.projection.frame(scene.shape[node], side, {-side.y(), side.x(), 0.0});
    if (turns) draw_spiral(sketch, f, length);
    else draw_zigzag(sketch, f, length, sketch.px(6.0));
    draw_ground(sketch, f.moved(length, 0.0).turned(pi / 2), sketch.px(turns ? 6.0 : 11.0));
    mark_support(scene, node, side, length);
    if (!scene.explains()) return;
    const auto measure = turns ? ui::Measure::MomentPerAngle : ui::Measure::ForcePerLength;
    sketch.caption(
        {.text = "k = " + scene.text(spring.stiffness, measure),
         .role = ui::Role::Spring,
         .target = f(0.6 * length, turns ? -length : 0.0),
         .toward = turns ? -f.y : ui::Point{std::abs(f.y.x) > 0.5 ? 1.0 : 0.0, std::abs(f.y.x) > 0.5 ? 0.0 : 1.0},
         .gap = sketch.px(9.0),
         .rank = Rank::Minor,
         .size = sketch.theme().type().small});
}

void note_angle(const Scene& scene, femoop::NodeId node, double degrees)
{
    if (degrees == 0.0 || !scene.explains()) return;
    const auto side = plane_support_side(scene, node);
    if (!side) return;
    scene.sketch.caption({.text = scene.text(degrees, ui::Measure::Angle),
                          .role = ui::Role::FaintLabel,
                          .target = scene.place(node) + scene.sketch.px(30.0) * scene.projection.direction(*side),
                          .toward = {0.0, 1.0},
                          .rank = Rank::Minor,
                          .size = scene.sketch.theme().type().small});
}

} // namespace

std::array<Vector3d, 2> plane_support_axes(const femoop::Support& support)
{
    const double angle = support.angle * pi / 180.0;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {Vector3d(c, s, 0.0), Vector3d(-s, c, 0.0)};
}

std::optional<Vector3d> plane_support_side(const Scene& scene, femoop::NodeId node)
{
    const auto& support = scene.model[node].support;
    if (!support) return std::nullopt;
    const SupportSymbol symbol = support_symbol(support->blocked(scene.model.analysis));
    if (symbol == SupportSymbol::None) return std::nullopt;
    // A wall stands square to the member that it holds, so it looks for the side straight opposite.
    const double room_enough = symbol == SupportSymbol::Wall ? -1.0 : 0.3;
    return least_occupied(scene, node, choices_for(symbol, plane_support_axes(*support)), room_enough);
}

void draw_plane_support(const Scene& scene, femoop::NodeId node)
{
    const femoop::Support& support = *scene.model[node].support;
    const auto axes = plane_support_axes(support);
    if (const auto side = plane_support_side(scene, node)) {
        draw(scene.sketch, support_symbol(support.blocked(scene.model.analysis)), standing(scene, node, *side));
        mark_support(scene, node, *side, scene.sketch.px(28.0));
    }
    for (const femoop::Spring& spring : support.springs) draw_spring(scene, node, spring, axes);
    note_angle(scene, node, support.angle);
}

} // namespace drawing
