#include "apps/mohr/view/circle_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/mohr/view/arrow.h"
#include "apps/mohr/view/axis.h"
#include "apps/mohr/view/labels.h"
#include "apps/mohr/view/names.h"
#include "apps/mohr/view/sentence.h"

namespace mohr {

namespace fm = femoop::mohr;
using ui::Role;
using ui::translatable;

namespace {

constexpr auto up_rule = fm::ShearRule::ClockwiseUp; // both rules give one picture; they differ in the numbers alone

ui::World2 face(const Solution& s, double angle)
{
    const fm::CirclePoint p = fm::face_point(s.plane, angle, up_rule);
    return {p.normal, p.shear};
}

/// Everything that the parts of the diagram share.
struct Diagram {
    ui::Painter& painter;
    const Scene& scene;
    ui::PlaneCamera camera;
    ui::Theme theme;
    Labels& labels;

    const Solution& solution() const { return scene.solution; }
    ui::Point at(ui::World2 p) const { return camera.to_sheet(p); }
    ui::Point centre() const { return at({solution().circle.centre, 0.0}); }
    double radius() const { return camera.scale() * solution().circle.radius; }
    ui::TextStyle words(Role role) const { return theme.text(role); }
    double sense() const { return solution().rule == fm::ShearRule::ClockwiseUp ? 1.0 : -1.0; }
    std::string pair(const std::string& name, ui::World2 p) const
    {
        return name + " (" + scene.look.number(p.x) + "; " + scene.look.number(sense() * p.y) + ")";
    }
};

void draw_space_circles(const Diagram& d)
{
    if (!d.scene.look.space || !d.solution().space) return;
    const ui::Stroke stroke = d.theme.stroke(Role::Undeformed);
    for (const fm::Circle& c : fm::circles(d.solution().space_principal))
        d.painter.circle(d.at({c.centre, 0.0}), d.camera.scale() * c.radius, stroke);
}

/// The circles that the state has gone through, and the line of their highest points.
void draw_path(const Diagram& d)
{
    constexpr std::size_t pieces = 24;
    std::vector<ui::Point> line;
    for (const fm::CirclePoint& p : fm::stress_path(d.solution().path, pieces))
        line.push_back(d.at({p.normal, p.shear}));
    if (line.size() > 1) d.painter.polyline(line, d.theme.stroke(Role::Guess));
    std::size_t number = 0;
    for (const fm::PlaneState& state : d.solution().path) {
        const auto [centre, radius] = fm::circle(state);
        d.painter.circle(d.at({centre, 0.0}), d.camera.scale() * radius, d.theme.stroke(Role::GridAxis));
        draw_mark(d.painter, d.scene, d.at({centre, radius}), std::nullopt, Role::Guess);
        d.labels.add(d.at({centre, radius}), {0.0, -1.0}, std::to_string(++number), d.words(Role::Guess), 3.0);
    }
}

void draw_radius(const Diagram& d, ui::World2 to, Role role)
{
    d.painter.line(d.centre(), d.at(to), d.theme.stroke(role));
}

void draw_angle(const Diagram& d, ui::World2 from, double turn, double share, const std::string& name)
{
    if (std::abs(turn) < 1e-3 || d.radius() < 20.0) return;
    const double start = std::atan2(from.y, from.x - d.solution().circle.centre);
    const ui::Arc arc{d.centre(), share * d.radius(), start, turn};
    arc_arrow(d.painter, arc, d.theme.stroke(Role::LocalAxes), 7.0 * d.theme.symbol_scale());
    std::vector<ui::Point> line;
    constexpr int n = 16;
    for (int i = 0; i <= n; ++i) line.push_back(arc.at(start + turn * i / n));
    d.labels.obstacles().add_polyline(line, 1.0, ui::Firmness::Soft);
    const double middle = start + 0.5 * turn;
    const ui::Point away{std::cos(middle), -std::sin(middle)};
    d.labels.add(arc.at(middle), away, name, d.words(Role::LocalAxes), 2.0);
}

void draw_pole(const Diagram& d, ui::World2 x, ui::World2 n)
{
    if (!d.scene.look.pole || d.radius() < 4.0) return;
    const fm::CirclePoint pole = fm::pole(d.solution().plane, up_rule);
    const ui::World2 p{pole.normal, pole.shear};
    const ui::Stroke line = d.theme.stroke(Role::Dimension);
    const auto through = [&](ui::World2 to) { // a little beyond both ends, as drawn with a ruler
        const ui::Point a = d.at(p), b = d.at(to), along = ui::direction(b - a);
        if (!(ui::distance(a, b) > 1.0)) return;
        d.painter.line(a - 18.0 * along, b + 18.0 * along, line);
        d.labels.obstacles().add_segment(a - 18.0 * along, b + 18.0 * along, 1.0, ui::Firmness::Soft);
    };
    through(x);
    through(n);
    draw_mark(d.painter, d.scene, d.at(p), std::nullopt, Role::Reaction);
    const ui::Point away = d.at(p) - d.centre();
    d.labels.add(d.at(p), away, d.scene.look.tr("pole"), d.words(Role::Reaction), 5.0);
}

void draw_point(const Diagram& d, ui::World2 p, Handle handle, Role role, const std::string& words, double priority)
{
    draw_mark(d.painter, d.scene, d.at(p), handle, role);
    const ui::Point away = d.radius() < 4.0 ? ui::Point{0.0, -1.0} : d.at(p) - d.centre();
    d.labels.add(d.at(p), away, words, d.words(role), priority);
}

/// The ends of the circle's two diameters that everyone looks for.
void draw_extremes(const Diagram& d)
{
    const Solution& s = d.solution();
    const Names names = names_of(d.scene.document.subject);
    const Look& look = d.scene.look;
    draw_point(d, {s.principal.first, 0.0}, Handle::First, Role::BendingMoment,
               names.first + " = " + look.number(s.principal.first), 8.0);
    if (d.radius() < 4.0) return;
    draw_point(d, {s.principal.second, 0.0}, Handle::Second, Role::BendingMoment,
               names.second + " = " + look.number(s.principal.second), 8.0);
    const ui::World2 top{s.circle.centre, s.circle.radius};
    draw_mark(d.painter, d.scene, d.at(top), std::nullopt, Role::ShearForce);
    d.labels.add(d.at(top), {0.0, -1.0}, "R = " + look.number(s.circle.radius), d.words(Role::ShearForce), 6.0);
}

void draw_faces(const Diagram& d)
{
    const Solution& s = d.solution();
    const double half_pi = 0.5 * std::numbers::pi;
    const ui::World2 x = face(s, 0.0), y = face(s, half_pi), n = face(s, s.angle);
    d.painter.line(d.at(x), d.at(y), d.theme.stroke(Role::Load));
    draw_radius(d, n, Role::Deformed);
    draw_pole(d, x, n);
    draw_angle(d, x, 2.0 * std::remainder(s.angle, std::numbers::pi), 0.30, "2θ");
    if (s.principal.angle) draw_angle(d, x, 2.0 * *s.principal.angle, 0.46, "2θp");
    draw_point(d, x, Handle::FaceX, Role::Load, d.pair("X", x), 9.0);
    draw_point(d, y, Handle::FaceY, Role::Load, d.pair("Y", y), 9.0);
    draw_point(d, n, Handle::Plane, Role::Deformed, d.pair("N", n), 10.0);
}

/// What each gauge of a rosette measures.
void draw_gauges(const Diagram& d)
{
    if (!d.solution().rosette) return;
    const fm::Rosette& rosette = *d.solution().rosette;
    for (std::size_t i = 0; i < 3; ++i) {
        const ui::World2 p = face(d.solution(), rosette.angles[i]);
        draw_mark(d.painter, d.scene, d.at(p), std::nullopt, Role::Torsion);
        d.labels.add(d.at(p), d.at(p) - d.centre(), std::string(1, "abc"[i]) + " = " + d.scene.look.number(p.x),
                     d.words(Role::Torsion), 3.0);
    }
}

void add_places(const Diagram& d, Drawn& drawn)
{
    const Solution& s = d.solution();
    const auto add = [&](Handle handle, ui::World2 p) { drawn.places.push_back({handle, d.at(p)}); };
    add(Handle::Plane, face(s, s.angle));
    add(Handle::FaceX, face(s, 0.0));
    add(Handle::FaceY, face(s, 0.5 * std::numbers::pi));
    add(Handle::First, {s.principal.first, 0.0});
    add(Handle::Second, {s.principal.second, 0.0});
    add(Handle::Centre, {s.circle.centre, 0.0});
}

void keep_clear(const Diagram& d)
{
    const ui::Arc around{d.centre(), d.radius(), 0.0, 2.0 * std::numbers::pi};
    std::vector<ui::Point> points;
    constexpr int n = 64;
    for (int i = 0; i <= n; ++i) points.push_back(around.at(2.0 * std::numbers::pi * i / n));
    d.labels.obstacles().add_polyline(points, 2.0, ui::Firmness::Soft);
    const Solution& s = d.solution();
    for (const double angle : {0.0, 0.5 * std::numbers::pi, s.angle}) {
        d.labels.obstacles().add_segment(d.centre(), d.at(face(s, angle)), 2.0, ui::Firmness::Soft);
        d.labels.obstacles().add_disc(d.at(face(s, angle)), 5.0);
    }
    for (const double value : {s.principal.first, s.principal.second, s.circle.centre})
        d.labels.obstacles().add_disc(d.at({value, 0.0}), 5.0);
}

std::string shear_rule(const Scene& scene)
{
    const Look& look = scene.look;
    if (is_in_space(scene.document.subject))
        return look.tr("in space the shear on a plane is a size, and N lies above the axis");
    if (scene.document.subject == Subject::Inertia)
        return look.tr("the axis of the product points down and counts −Ixy");
    if (scene.solution.rule == fm::ShearRule::TensorDown)
        return look.tr("the shear axis points down, with the signs of the axes x′y′ of the face");
    return look.tr("shear is up where it turns the element clockwise");
}

void write(ui::Painter& painter, Labels& labels, ui::Point at, const std::string& text, const ui::TextStyle& style)
{
    painter.text(at, text, style);
    labels.obstacles().add_box(ui::text_box(painter.fonts(), at, text, style));
}

void draw_ticks(ui::Painter& painter, const Scene& scene, const ui::Box& box, const ui::PlaneCamera& camera,
                Labels& labels)
{
    const ui::Theme theme = scene.look.full_theme();
    const double step = tick_step(camera.scale(), 5.0 * theme.type().small);
    const ui::World2 low = camera.to_world({box.min.x, box.max.y}), high = camera.to_world({box.max.x, box.min.y});
    ui::TextStyle style = theme.text(Role::FaintLabel, ui::Anchor::Top);
    style.size = theme.type().small;
    const double zero_x = std::clamp(camera.to_sheet({0.0, 0.0}).x, box.min.x, box.max.x);
    const bool is_down = scene.solution.rule == fm::ShearRule::TensorDown;
    const int first = static_cast<int>(std::ceil(low.x / step)), last = static_cast<int>(std::floor(high.x / step));
    for (int i = first; i <= last && last - first < 200; ++i) {
        const ui::Point at = camera.to_sheet({i * step, 0.0});
        painter.line({at.x, box.min.y}, {at.x, box.max.y}, theme.stroke(Role::Grid));
        if (i != 0) write(painter, labels, at + ui::Point{0.0, 3.0}, scene.look.number(i * step), style);
    }
    style.anchor = ui::Anchor::Right;
    const int bottom = static_cast<int>(std::ceil(low.y / step)), top = static_cast<int>(std::floor(high.y / step));
    for (int i = bottom; i <= top && top - bottom < 200; ++i) {
        const ui::Point at = camera.to_sheet({0.0, i * step});
        painter.line({box.min.x, at.y}, {box.max.x, at.y}, theme.stroke(Role::Grid));
        const bool has_room = zero_x > box.min.x + 4.0 * style.size;
        style.anchor = has_room ? ui::Anchor::Right : ui::Anchor::Left;
        const double room = 1.5 * style.size; // for the axis's title and the rule of signs
        if (i == 0 || at.y < box.min.y + room || at.y > box.max.y - room) continue;
        write(painter, labels, {zero_x + (has_room ? -4.0 : 4.0), at.y},
              scene.look.number((is_down ? -1.0 : 1.0) * i * step), style);
    }
}

} // namespace

ui::PlaneCamera circle_camera(const Frame& frame, const ui::Box& box, const Look& look)
{
    const bool is_projected = look.theme == ui::ThemeName::Projector; // large type takes room from the circle
    const double ems = is_projected ? 3.8 : 4.2, most = is_projected ? 0.15 : 0.18;
    const double margin = std::min(ems * look.full_theme().type().normal, most * std::min(box.width(), box.height()));
    const double across = std::max(10.0, box.width() - 2.0 * margin),
                 high = std::max(10.0, box.height() - 2.0 * margin);
    const double scale = std::min(across / (frame.high - frame.low), high / (2.0 * frame.reach));
    const double middle = 0.5 * (frame.low + frame.high);
    return {{box.center().x - scale * middle, box.center().y}, scale};
}

void draw_axes(ui::Painter& painter, const Scene& scene, const ui::Box& box, const ui::PlaneCamera& camera,
               Labels& labels)
{
    const ui::Theme theme = scene.look.full_theme();
    const Names names = names_of(scene.document.subject);
    {
        const ui::LayerScope layer(painter, ui::Layer::Grid);
        draw_ticks(painter, scene, box, camera, labels);
    }
    const ui::Stroke stroke = theme.stroke(Role::Label);
    const ui::Point zero = camera.to_sheet({0.0, 0.0});
    const double head = 9.0 * theme.symbol_scale();
    arrow(painter, {box.min.x, zero.y}, {box.max.x, zero.y}, stroke, head);
    ui::TextStyle style = theme.text(Role::Label, ui::Anchor::BottomRight);
    write(painter, labels, {box.max.x, zero.y - 5.0}, axis_title(names.normal, scene.solution.unit), style);
    labels.obstacles().add_segment({box.min.x, zero.y}, {box.max.x, zero.y}, 1.0, ui::Firmness::Soft);
    const double x = std::clamp(zero.x, box.min.x, box.max.x);
    const bool is_down = scene.solution.rule == fm::ShearRule::TensorDown;
    const ui::Point top{x, box.min.y}, bottom{x, box.max.y};
    if (x == zero.x) arrow(painter, is_down ? top : bottom, is_down ? bottom : top, stroke, head);
    style.anchor = is_down ? ui::Anchor::BottomLeft : ui::Anchor::TopLeft;
    write(painter, labels, (is_down ? bottom : top) + ui::Point{8.0, 0.0}, axis_title(names.shear, scene.solution.unit),
          style);
    labels.obstacles().add_segment(top, bottom, 1.0, ui::Firmness::Soft);
}

ui::Box write_rule(ui::Painter& painter, const Scene& scene, const ui::Box& box)
{
    ui::TextStyle faint = scene.look.full_theme().text(Role::FaintLabel);
    faint.size = scene.look.full_theme().type().small;
    return write_at_foot(painter, box, shear_rule(scene), faint, scene.look.both_rules ? 2 : 1); // both feet level
}

void draw_mark(ui::Painter& painter, const Scene& scene, ui::Point at, std::optional<Handle> handle, ui::Role role)
{
    const ui::Theme theme = scene.look.full_theme();
    const ui::LayerScope layer(painter, ui::Layer::Symbols);
    const double r = 4.5 * theme.symbol_scale();
    if (handle && scene.hover == handle) painter.circle(at, r + 5.0, theme.stroke(Role::Hover));
    painter.disc(at, r, theme.stroke(role).color);
    if (!handle) painter.disc(at, 0.5 * r, theme.background());
}

void draw_criterion(ui::Painter& painter, const Scene& scene, const ui::Box& box, const ui::PlaneCamera& camera)
{
    const Solution& s = scene.solution;
    if (!scene.look.envelope || !s.strength || !fm::is_stress(s.state.kind)) return;
    const ui::Theme theme = scene.look.full_theme();
    const ui::ClipScope clip(painter, box);
    const bool is_in_plane = *scene.document.criterion == fm::Criterion::VonMises ||
                             *scene.document.criterion == fm::Criterion::DruckerPrager;
    const double low = camera.to_world(box.min).x, high = camera.to_world(box.max).x;
    const double share = s.state.kind == fm::Kind::PlaneStrain ? *s.state.nu : 0.0;
    if (!is_in_plane || fm::is_plane(s.state.kind))
        for (const fm::Curve& curve : fm::envelope(*scene.document.criterion, *s.strength, low, high, share))
            for (const double side : {1.0, -1.0}) {
                std::vector<ui::Point> points;
                for (const auto& [normal, shear] : curve) points.push_back(camera.to_sheet({normal, side * shear}));
                painter.polyline(points, theme.stroke(Role::Error));
            }
    if (!s.safety || !s.safety->factor) return;
    const fm::Circle largest = fm::circles(s.space_principal)[0];
    const double k = *s.safety->factor;
    painter.circle(camera.to_sheet({k * largest.centre, 0.0}), k * camera.scale() * largest.radius,
                   theme.stroke(Role::Warning));
}

void draw_circle(ui::Painter& painter, const Scene& scene, const ui::Box& sheet, Drawn& drawn)
{
    const ui::Box box = write_rule(painter, scene, sheet);
    Labels labels(box, painter.fonts());
    drawn.circle = circle_camera(scene.frame, box, scene.look);
    const Diagram d{painter, scene, drawn.circle, scene.look.full_theme(), labels};
    draw_axes(painter, scene, box, d.camera, labels);
    draw_criterion(painter, scene, box, d.camera);
    {
        const ui::ClipScope clip(painter, box);
        draw_space_circles(d);
        draw_path(d);
        painter.circle(d.centre(), d.radius(), d.theme.stroke(Role::Member));
    }
    keep_clear(d);
    draw_extremes(d);
    if (d.radius() >= 4.0) draw_faces(d);
    if (d.radius() >= 4.0) draw_gauges(d);
    draw_mark(painter, scene, d.centre(), Handle::Centre, Role::Node);
    labels.add(d.centre(), {0.0, 1.0}, "C = " + scene.look.number(scene.solution.circle.centre), d.words(Role::Label),
               4.0);
    labels.draw(painter, d.theme.stroke(Role::Leader), d.theme.background());
    add_places(d, drawn);
}

} // namespace mohr
