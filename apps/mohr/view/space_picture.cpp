#include "apps/mohr/view/space_picture.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "apps/mohr/view/arrow.h"
#include "apps/mohr/view/circle_picture.h"
#include "apps/mohr/view/labels.h"
#include "apps/mohr/view/names.h"

namespace mohr {

namespace fm = femoop::mohr;
using Eigen::Vector3d;
using ui::Role;

namespace {

using std::numbers::pi;

/// The eye's direction, with a scale of its own: `radius` pixels for a length of 1 about `middle`.
struct View {
    ui::OrbitCamera eye;
    ui::Point middle;
    double radius;

    ui::Point at(const Vector3d& v) const
    {
        const ui::World3 right = eye.right(), up = eye.up();
        const double x = v[0] * right.x + v[1] * right.y + v[2] * right.z, y = v[0] * up.x + v[1] * up.y + v[2] * up.z;
        return middle + ui::Point{radius * x, -radius * y};
    }
    double nearness(const Vector3d& v) const
    {
        const ui::World3 e = eye.toward_eye();
        return v[0] * e.x + v[1] * e.y + v[2] * e.z;
    }
};

constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};

void draw_face(ui::Painter& painter, const Scene& scene, const View& view, int axis, double side)
{
    const ui::Theme theme = scene.look.full_theme();
    const Vector3d n = side * Vector3d::Unit(axis), u = Vector3d::Unit((axis + 1) % 3),
                   v = Vector3d::Unit((axis + 2) % 3);
    const double h = 0.5;
    const std::array corners{view.at(h * (n - u - v)), view.at(h * (n + u - v)), view.at(h * (n + u + v)),
                             view.at(h * (n - u + v))};
    painter.polygon(corners, theme.fill(Role::Deformed));
    painter.polyline(corners, theme.stroke(Role::Edge), ui::PathEnds::Closed);
}

constexpr double arrow_length = 0.75; // of the cube's side, for the largest component

/// The arrows of one face that a hand pulls: the normal stress, and the shear along the next axis. An arrow that points
/// at the eye cannot be pulled.
void add_cube_arrows(const Scene& scene, const View& view, int axis, double side, Drawn& drawn)
{
    constexpr std::array normal{Handle::CubeX, Handle::CubeY, Handle::CubeZ},
        shear{Handle::CubeXY, Handle::CubeYZ, Handle::CubeZX};
    constexpr double least = 0.2; // of the view's scale
    const double per_unit = arrow_length / scene.frame.largest;
    const auto add = [&](Handle handle, double value, const Vector3d& root, const Vector3d& along, double length) {
        const ui::Point growth = view.at(per_unit * along) - view.middle;
        if (ui::length(growth) < least * per_unit * view.radius) return;
        const ui::Point tip = view.at(root + length * along);
        drawn.cube.push_back({handle, value, tip, growth});
        drawn.places.push_back({handle, tip});
    };
    const Eigen::Matrix3d S = fm::tensor(*scene.solution.space);
    const Vector3d n = side * Vector3d::Unit(axis);
    const int next = (axis + 1) % 3;
    const double sigma = S(axis, axis), tau = S(next, axis);
    add(normal[static_cast<std::size_t>(axis)], sigma, 0.53 * n, n, per_unit * std::abs(sigma));
    const double beside = 0.1; // where there is no arrow, beside that of the normal stress
    const double shown = std::abs(per_unit * tau) < beside ? std::copysign(beside, tau) : per_unit * tau;
    add(shear[static_cast<std::size_t>(axis)], tau, 0.51 * n, side * Vector3d::Unit(next), shown);
}

/// A ring about the arrow's tip that lies under the pointer.
void draw_hovered(ui::Painter& painter, const Scene& scene, const Drawn& drawn)
{
    const ui::Theme theme = scene.look.full_theme();
    for (const CubeArrow& one : drawn.cube)
        if (scene.hover == one.handle) painter.circle(one.tip, 9.0 * theme.symbol_scale(), theme.stroke(Role::Hover));
}

/// What acts on the face: the tensor's column, its three parts each an arrow.
void draw_face_arrows(ui::Painter& painter, const Scene& scene, const View& view, int axis, double side, Labels& labels)
{
    const ui::Theme theme = scene.look.full_theme();
    const Vector3d n = side * Vector3d::Unit(axis), traction = fm::tensor(*scene.solution.space) * n;
    const double head = 8.0 * theme.symbol_scale();
    for (int part = 0; part < 3; ++part) {
        const double size = arrow_length * traction[part] / scene.frame.largest;
        if (std::abs(size) < 0.01) continue;
        const bool is_normal = part == axis;
        const Vector3d along = Vector3d::Unit(part);
        const Vector3d from = is_normal ? Vector3d(0.53 * n) : Vector3d(0.51 * n);
        const bool is_push = is_normal && size * side < 0.0;
        const Vector3d near = from, far = from + (is_push ? -1.0 : 1.0) * size * along;
        arrow(painter, view.at(is_push ? far : near), view.at(is_push ? near : far),
              solid(theme.stroke(is_normal ? Role::BendingMoment : Role::ShearForce)), head);
        if (!is_normal) continue;
        ui::TextStyle style = theme.text(Role::BendingMoment);
        labels.add(view.at(far), view.at(far) - view.middle,
                   std::string("σ") + axis_names[part] + " = " + scene.look.number(side * traction[part]), style, 3.0);
    }
}

std::array<double, 3> visible_sides(const View& view)
{
    std::array<double, 3> sides{};
    for (int axis = 0; axis < 3; ++axis) sides[axis] = view.nearness(Vector3d::Unit(axis)) >= 0.0 ? 1.0 : -1.0;
    return sides;
}

/// The part of the oblique plane through the middle that lies in the cube, its corners in order about the normal.
std::vector<Vector3d> cut_of_cube(const Vector3d& n)
{
    std::vector<Vector3d> points;
    for (int axis = 0; axis < 3; ++axis)
        for (const double a : {-0.5, 0.5})
            for (const double b : {-0.5, 0.5}) {
                const int i = (axis + 1) % 3, j = (axis + 2) % 3;
                if (std::abs(n[axis]) < 1e-9) continue;
                const double c = -(n[i] * a + n[j] * b) / n[axis];
                if (std::abs(c) > 0.5) continue;
                Vector3d p;
                p[axis] = c;
                p[i] = a;
                p[j] = b;
                points.push_back(p);
            }
    const Vector3d u = n.unitOrthogonal(), v = n.cross(u);
    std::ranges::sort(points, {}, [&](const Vector3d& p) { return std::atan2(p.dot(v), p.dot(u)); });
    return points;
}

View view_of(const Scene& scene, const ui::Box& box, double share)
{
    return {scene.eye, box.center(), share * std::min(box.width(), box.height())};
}

/// Half a great circle about an axis: the half that is seen, or the hidden one.
void draw_great_circle(ui::Painter& painter, const View& view, const Vector3d& axis, const ui::Stroke& front,
                       const ui::Stroke& back)
{
    const Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
    constexpr int n = 72;
    std::vector<ui::Point> line;
    bool is_front = true;
    for (int i = 0; i <= n; ++i) {
        const double t = 2.0 * pi * i / n;
        const Vector3d p = std::cos(t) * u + std::sin(t) * v;
        const bool is_near = view.nearness(p) >= 0.0;
        if (!line.empty() && is_near != is_front) {
            line.push_back(view.at(p));
            painter.polyline(line, is_front ? front : back);
            line.clear();
        }
        is_front = is_near;
        line.push_back(view.at(p));
    }
    if (line.size() > 1) painter.polyline(line, is_front ? front : back);
}

void draw_directions(ui::Painter& painter, const Scene& scene, const View& view, Labels& labels)
{
    const ui::Theme theme = scene.look.full_theme();
    const double head = 8.0 * theme.symbol_scale();
    for (int i = 0; i < 3; ++i) {
        const Vector3d axis = 1.3 * Vector3d::Unit(i);
        arrow(painter, view.middle, view.at(axis), theme.stroke(Role::Label), head);
        labels.add(view.at(axis), view.at(axis) - view.middle, axis_names[i], theme.text(Role::Label), 5.0);
    }
    if (scene.conceals) return;
    const std::array<std::string, 3> names{"1", "2", "3"};
    for (int i = 0; i < 3; ++i) {
        Vector3d d = scene.solution.space_principal.directions.col(i);
        if (view.nearness(d) < 0.0) d = -d;
        painter.line(view.middle, view.at(d), theme.stroke(Role::Undeformed));
        draw_mark(painter, scene, view.at(d), std::nullopt, Role::BendingMoment);
        labels.add(view.at(d), view.at(d) - view.middle, names[i], theme.text(Role::BendingMoment), 4.0);
    }
}

/// The half above the axis of a circle of the diagram, from right to left or back.
void add_half(std::vector<ui::Point>& points, const ui::PlaneCamera& camera, const fm::Circle& circle, bool is_back)
{
    constexpr int n = 60;
    for (int i = 0; i <= n; ++i) {
        const double t = pi * (is_back ? n - i : i) / n;
        points.push_back(camera.to_sheet({circle.centre + circle.radius * std::cos(t), circle.radius * std::sin(t)}));
    }
}

void draw_values(const Scene& scene, ui::Painter& painter, Labels& labels, Drawn& drawn)
{
    const ui::PlaneCamera& camera = drawn.circle;
    constexpr std::array handles{Handle::First, Handle::Second, Handle::Third};
    const ui::Theme theme = scene.look.full_theme();
    const Names names = names_of(scene.document.subject);
    const std::array<std::string, 3> words{names.first, names.second, names.third};
    for (std::size_t i = 0; i < 3; ++i) {
        const double value = scene.solution.space_principal.values[i];
        const ui::Point at = camera.to_sheet({value, 0.0});
        draw_mark(painter, scene, at, handles[i], Role::BendingMoment);
        drawn.places.push_back({handles[i], at});
        labels.add(at, {i == 1 ? 0.0 : (i == 0 ? 1.0 : -1.0), 1.0}, words[i] + " = " + scene.look.number(value),
                   theme.text(Role::BendingMoment), 8.0);
    }
    const fm::Circle largest = fm::circles(scene.solution.space_principal)[0];
    const ui::Point top = camera.to_sheet({largest.centre, largest.radius});
    draw_mark(painter, scene, top, std::nullopt, Role::ShearForce);
    labels.add(top, {0.0, -1.0}, "τmax = " + scene.look.number(largest.radius), theme.text(Role::ShearForce), 7.0);
}

void draw_plane_point(const Scene& scene, const ui::PlaneCamera& camera, ui::Painter& painter, Labels& labels)
{
    const ui::Theme theme = scene.look.full_theme();
    const fm::OnPlane& on = scene.solution.on_plane;
    const ui::Point at = camera.to_sheet({on.normal_component, on.shear});
    const ui::Point foot = camera.to_sheet({on.normal_component, 0.0}), side = camera.to_sheet({0.0, on.shear});
    painter.line(at, foot, theme.stroke(Role::Dimension));
    painter.line(at, side, theme.stroke(Role::Dimension));
    draw_mark(painter, scene, at, std::nullopt, Role::Deformed);
    labels.add(at, {1.0, -1.0},
               "N (" + scene.look.number(on.normal_component) + "; " + scene.look.number(on.shear) + ")",
               theme.text(Role::Deformed), 10.0);
}

} // namespace

void draw_cube(ui::Painter& painter, const Scene& scene, const ui::Box& box, Drawn& drawn)
{
    const View view = view_of(scene, box, 0.34);
    const ui::Theme theme = scene.look.full_theme();
    Labels labels(box, painter.fonts());
    const auto sides = visible_sides(view);
    std::vector<ui::Point> cut;
    for (const Vector3d& p : cut_of_cube(scene.solution.on_plane.normal)) cut.push_back(view.at(p));
    painter.polygon(cut, theme.fill(Role::Guess));
    painter.polyline(cut, theme.stroke(Role::Guess), ui::PathEnds::Closed);
    for (int axis = 0; axis < 3; ++axis) draw_face(painter, scene, view, axis, sides[axis]);
    for (int axis = 0; axis < 3; ++axis) draw_face_arrows(painter, scene, view, axis, sides[axis], labels);
    labels.draw(painter, theme);
    for (int axis = 0; axis < 3; ++axis) add_cube_arrows(scene, view, axis, sides[axis], drawn);
    draw_hovered(painter, scene, drawn);
}

void draw_sphere(ui::Painter& painter, const Scene& scene, const ui::Box& box, Drawn& drawn)
{
    const View view = view_of(scene, box, 0.32);
    const ui::Theme theme = scene.look.full_theme();
    Labels labels(box, painter.fonts());
    painter.disc(view.middle, view.radius, theme.fill(Role::Support));
    painter.circle(view.middle, view.radius, theme.stroke(Role::Edge));
    for (int axis = 0; axis < 3; ++axis)
        draw_great_circle(painter, view, Vector3d::Unit(axis), theme.stroke(Role::GridAxis), theme.stroke(Role::Grid));
    draw_directions(painter, scene, view, labels);
    const Vector3d n = scene.solution.on_plane.normal;
    arrow(painter, view.middle, view.at(n), theme.stroke(Role::Deformed), 10.0 * theme.symbol_scale());
    draw_mark(painter, scene, view.at(n), Handle::Normal, Role::Deformed);
    labels.add(view.at(n), view.at(n) - view.middle, "n", theme.text(Role::Deformed), 9.0);
    labels.draw(painter, theme);
    drawn.sphere = {view.middle, view.radius, view.eye};
    drawn.places.push_back({Handle::Normal, view.at(n)});
}

void draw_region(ui::Painter& painter, const Scene& scene, const ui::PlaneCamera& camera)
{
    const auto circles = fm::circles(scene.solution.space_principal);
    std::vector<ui::Point> region;
    add_half(region, camera, circles[0], false);
    add_half(region, camera, circles[2], true);
    add_half(region, camera, circles[1], true);
    const ui::LayerScope layer(painter, ui::Layer::Areas);
    painter.polygon(region, scene.look.full_theme().fill(Role::Deformed));
}

void draw_three_circles(ui::Painter& painter, const Scene& scene, const ui::Box& sheet, Drawn& drawn)
{
    const ui::Theme theme = scene.look.full_theme();
    const ui::Box box = write_rule(painter, scene, sheet);
    Labels labels(box, painter.fonts());
    drawn.circle = circle_camera(scene.frame, box, scene.look);
    const auto circles = fm::circles(scene.solution.space_principal);
    draw_axes(painter, scene, box, drawn.circle, labels);
    draw_criterion(painter, scene, box, drawn.circle);
    draw_region(painter, scene, drawn.circle);
    for (const fm::Circle& c : circles)
        painter.circle(drawn.circle.to_sheet({c.centre, 0.0}), drawn.circle.scale() * c.radius,
                       theme.stroke(Role::Bar));
    draw_values(scene, painter, labels, drawn);
    draw_plane_point(scene, drawn.circle, painter, labels);
    labels.draw(painter, theme);
}

} // namespace mohr
