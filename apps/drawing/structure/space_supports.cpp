#include "apps/drawing/structure/space_supports.h"

#include "apps/drawing/sketch/symbols.h"
#include "apps/drawing/structure/support_side.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace drawing {

namespace {

using Eigen::Vector3d;
using femoop::Dof;
using femoop::DofSet;

using std::numbers::pi;

bool contains_all(DofSet set, DofSet wanted)
{
    return std::all_of(femoop::all_dofs.begin(), femoop::all_dofs.end(),
                       [&](Dof dof) { return !wanted.contains(dof) || set.contains(dof); });
}

DofSet translations(DofSet set)
{
    DofSet found;
    for (const Dof dof : {Dof::ux, Dof::uy, Dof::uz})
        if (set.contains(dof)) found.insert(dof);
    return found;
}

Vector3d axis_of(Dof dof) { return Vector3d::Unit(static_cast<int>(femoop::index(dof) % 3)); }

/// Two directions square to `normal` and to each other.
std::array<Vector3d, 2> across(const Vector3d& normal)
{
    const Vector3d a = std::abs(normal.x()) > 0.9 ? Vector3d::UnitY() : Vector3d::UnitX();
    const Vector3d first = (a - a.dot(normal) * normal).normalized();
    return {first, normal.cross(first)};
}

std::vector<ui::Point> square(const SymbolFrame& f, double half)
{
    return {f(-half, -half), f(half, -half), f(half, half), f(-half, half)};
}

void outline(Sketch& sketch, const std::vector<ui::Point>& corners, ui::Color fill)
{
    sketch.polygon(corners, fill);
    sketch.polyline(corners, sketch.thin(ui::Role::Support), Clearance::Hard, ui::PathEnds::Closed);
}

// A square plate under the node, hatched as ground.
void draw_plate(const Scene& scene, femoop::NodeId node, const Vector3d& side)
{
    Sketch& sketch = scene.sketch;
    const auto [a, b] = across(side);
    const SymbolFrame f = scene.projection.frame(scene.shape[node], a, b);
    const double half = sketch.px(13.0);
    outline(sketch, square(f, half), sketch.theme().fill(ui::Role::Support));
    constexpr int n = 5;
    for (int i = 1; i < 2 * n; ++i) {
        const double c = -2.0 * half + i * 2.0 * half / n;
        const double lo = std::max(-half, c - half);
        const double hi = std::min(half, c + half);
        sketch.line(f(lo, c - lo), f(hi, c - hi), sketch.thin(ui::Role::Support), Clearance::None);
    }
}

// Apex at the node, base on the ground; faces from back to front.
void draw_pyramid(const Scene& scene, femoop::NodeId node, const Vector3d& side)
{
    Sketch& sketch = scene.sketch;
    const auto [a, b] = across(side);
    const double height = sketch.px(20.0);
    const double half = sketch.px(9.0);
    const double unit = 1.0 / scene.projection.scale();
    const Vector3d foot = scene.shape[node] + height * unit * side;
    std::array<Vector3d, 4> corners{};
    for (int i = 0; i < 4; ++i) {
        const double s = (i == 1 || i == 2) ? half : -half;
        const double t = i >= 2 ? half : -half;
        corners[static_cast<std::size_t>(i)] = foot + unit * (s * a + t * b);
    }
    mark_support(scene, node, side, height);
    const auto at = [&](std::size_t i) { return scene.projection(corners[i % 4]); };
    outline(sketch, {at(0), at(1), at(2), at(3)}, sketch.theme().fill(ui::Role::Support));
    std::array<std::size_t, 4> faces{0, 1, 2, 3};
    const auto nearness = [&](std::size_t i) {
        return scene.projection.nearness(0.5 * (corners[i] + corners[(i + 1) % 4]));
    };
    std::sort(faces.begin(), faces.end(), [&](auto i, auto j) { return nearness(i) < nearness(j); });
    for (const std::size_t i : faces)
        outline(sketch, {scene.place(node), at(i), at(i + 1)}, sketch.theme().fill(ui::Role::Support));
}

// A flat cone that points at the node along the blocked direction, with the ground behind it.
void draw_cone(const Scene& scene, femoop::NodeId node, const Vector3d& side)
{
    Sketch& sketch = scene.sketch;
    const Vector3d flat = across(side)[0];
    const SymbolFrame f = scene.projection.frame(scene.shape[node], flat, -side);
    const double half = sketch.px(6.0);
    const double height = sketch.px(15.0);
    outline(sketch, {f(0.0, 0.0), f(-half, -height), f(half, -height)}, sketch.theme().fill(ui::Role::Support));
    draw_ground(sketch, f.moved(0.0, -height), sketch.px(9.0));
}

// Two short bars across the axis about which the node cannot turn.
void draw_turn_lock(const Scene& scene, femoop::NodeId node, const Vector3d& side)
{
    Sketch& sketch = scene.sketch;
    const auto [a, b] = across(side);
    const double unit = 1.0 / scene.projection.scale();
    const SymbolFrame f = scene.projection.frame(scene.shape[node] + sketch.px(11.0) * unit * side, a, b);
    outline(sketch, square(f, sketch.px(5.0)), sketch.theme().fill(ui::Role::Support));
    sketch.line(scene.place(node), f.origin, sketch.stroke(ui::Role::Support));
}

Vector3d free_way(const Scene& scene, femoop::NodeId node, const Vector3d& axis)
{
    const std::array<SideChoice, 2> sides{{{-axis, 0.0}, {axis, axis.z() > 0.5 ? 0.5 : 0.0}}};
    return least_occupied(scene, node, sides);
}

void draw_spring(const Scene& scene, femoop::NodeId node, const femoop::Spring& spring)
{
    Sketch& sketch = scene.sketch;
    const bool turns = femoop::is_rotation(spring.dof);
    const Vector3d side = free_way(scene, node, axis_of(spring.dof));
    const auto [a, b] = across(side);
    const double length = sketch.px(turns ? 14.0 : 36.0);
    mark_support(scene, node, side, length);
    if (turns) {
        const SymbolFrame f = scene.projection.frame(scene.shape[node], a, b);
        draw_spiral(sketch, f, length);
        draw_ground(sketch, f.moved(length, 0.0).turned(pi / 2), sketch.px(6.0));
    } else {
        const SymbolFrame f = scene.projection.frame(scene.shape[node], side, a);
        draw_zigzag(sketch, f, length, sketch.px(6.0));
        draw_ground(sketch, f.moved(length, 0.0).turned(pi / 2), sketch.px(10.0));
    }
    if (!scene.explains()) return;
    const auto measure = turns ? ui::Measure::MomentPerAngle : ui::Measure::ForcePerLength;
    sketch.caption({.text = "k = " + scene.text(spring.stiffness, measure),
                    .role = ui::Role::Spring,
                    .target = scene.place(node) + 0.6 * length * scene.projection.direction(side),
                    .toward = {1.0, 0.2},
                    .gap = sketch.px(10.0),
                    .rank = Rank::Minor,
                    .size = sketch.theme().type().small});
}

void draw_blocked_one_by_one(const Scene& scene, femoop::NodeId node, DofSet blocked)
{
    for (const Dof dof : femoop::all_dofs) {
        if (!blocked.contains(dof)) continue;
        const Vector3d side = free_way(scene, node, axis_of(dof));
        mark_support(scene, node, side, scene.sketch.px(16.0));
        if (femoop::is_rotation(dof)) draw_turn_lock(scene, node, side);
        else draw_cone(scene, node, side);
    }
}

} // namespace

Vector3d space_support_side(const Scene& scene, femoop::NodeId node)
{
    const Vector3d x = Vector3d::UnitX();
    const Vector3d y = Vector3d::UnitY();
    const Vector3d z = Vector3d::UnitZ();
    const auto& support = scene.model[node].support;
    const bool is_plate = support && contains_all(support->blocked(scene.model.analysis), dofs(scene.model.analysis));
    const double usual = is_plate ? 0.1 : 0.5;
    const std::array<SideChoice, 6> sides{
        {{-z, is_plate ? 0.15 : 0.0}, {-x, usual}, {x, usual}, {-y, usual}, {y, usual}, {z, 0.6}}};
    if (is_plate && scene.model.analysis == femoop::AnalysisKind::Grillage)
        return least_occupied(scene, node, std::span(sides).subspan(1, 4));
    // A plate is square to the member that ends there, so the side right behind it is the best.
    return is_plate ? least_occupied(scene, node, sides, -1.0) : least_occupied(scene, node, sides);
}

void draw_space_support(const Scene& scene, femoop::NodeId node)
{
    const femoop::Support& support = *scene.model[node].support;
    const DofSet blocked = support.blocked(scene.model.analysis);
    const DofSet all = femoop::dofs(scene.model.analysis);
    const bool has_rotations = !(translations(blocked) == blocked);
    const bool is_pin = contains_all(blocked, translations(all)) && !has_rotations;
    const bool is_fixed = contains_all(blocked, all) && has_rotations;
    if (is_fixed) draw_plate(scene, node, space_support_side(scene, node));
    else if (is_pin) draw_pyramid(scene, node, space_support_side(scene, node));
    else draw_blocked_one_by_one(scene, node, blocked);
    for (const femoop::Spring& spring : support.springs) draw_spring(scene, node, spring);
}

} // namespace drawing
