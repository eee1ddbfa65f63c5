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
    const bool has_plane = d.scene.look.plane;
    if (has_plane) draw_radius(d, n, Role::Deformed);
    draw_pole(d, x, has_plane ? n : y);
    if (has_plane) draw_angle(d, x, 2.0 * std::remainder(s.angle, std::numbers::pi), 0.30, "2θ");
    if (s.principal.angle) draw_angle(d, x, 2.0 * *s.principal.angle, 0.46, "2θp");
    draw_point(d, x, Handle::FaceX, Role::Load, d.pair("X", x), 10.0);
    draw_point(d, y, Handle::FaceY, Role::Load, d.pair("Y", y), 10.0);
    if (has_plane) draw_point(d, n, Handle::Plane, Role::Deformed, d.pair("N", n), 9.0);
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

std::string shear_rule(const Scene& scene, fm::ShearRule rule)
{
    const Look& look = scene.look;
    if (is_in_space(scene.document.subject))
        return look.tr("in space the shear on a plane is a size, and N lies above the axis");
    if (scene.document.subject == Subject::Inertia)
        return look.tr("the axis of the product points down and counts −Ixy");
    if (rule == fm::ShearRule::TensorDown)
        return look.tr("the shear axis points down, with the signs of the axes x′y′ of the face");
    return look.tr("shear is up where it turns the element clockwise");
}

/// The numbers along both axes, each at its grid line, where no line of the diagram runs through it.
class Ticks {
public:
    Ticks(ui::Painter& painter, const Scene& scene, const ui::Box& box, const ui::PlaneCamera& camera, Labels& labels)
        : painter_(painter),
          scene_(scene),
          box_(box),
          camera_(camera),
          labels_(labels),
          theme_(scene.look.full_theme()),
          step_(tick_step(camera.scale(), 5.0 * theme_.type().small)),
          near_(3.0 + 0.5 * theme_.stroke(Role::Label).width),
          style_(theme_.text(Role::FaintLabel))
    {
        style_.size = theme_.type().small;
    }

    void draw_normals() const
    {
        const double low = camera_.to_world(box_.min).x, high = camera_.to_world(box_.max).x;
        for_each(low, high, [&](int i) {
            const ui::Point at = camera_.to_sheet({i * step_, 0.0});
            painter_.line({at.x, box_.min.y}, {at.x, box_.max.y}, theme_.stroke(Role::Grid));
            if (i != 0)
                write(
                    at, i,
                    {{0.0, near_}, {0.0, -near_}, {near_, near_}, {-near_, near_}, {near_, -near_}, {-near_, -near_}});
        });
    }

    void draw_shears() const
    {
        const double low = camera_.to_world(box_.max).y, high = camera_.to_world(box_.min).y;
        const double zero = std::clamp(camera_.to_sheet({0.0, 0.0}).x, box_.min.x, box_.max.x);
        const int sense = scene_.solution.rule == fm::ShearRule::TensorDown ? -1 : 1;
        const double room = 1.5 * style_.size; // for the axis's title and the rule of signs
        for_each(low, high, [&](int i) {
            const double y = camera_.to_sheet({0.0, i * step_}).y;
            painter_.line({box_.min.x, y}, {box_.max.x, y}, theme_.stroke(Role::Grid));
            if (i == 0 || y < box_.min.y + room || y > box_.max.y - room) return;
            write({zero, y}, sense * i,
                  {{-near_, 0.0}, {near_, 0.0}, {-near_, -near_}, {-near_, near_}, {near_, -near_}, {near_, near_}});
        });
    }

private:
    template <class Act> void for_each(double low, double high, const Act& act) const
    {
        constexpr int most = 200;
        const int first = static_cast<int>(std::ceil(low / step_)), last = static_cast<int>(std::floor(high / step_));
        for (int i = first; i <= last && last - first < most; ++i) act(i);
    }
    void write(ui::Point at, int i, const std::vector<ui::Point>& sides) const
    {
        labels_.add_fixed(at, sides, scene_.look.number(i * step_), style_);
    }

    ui::Painter& painter_;
    const Scene& scene_;
    ui::Box box_;
    ui::PlaneCamera camera_;
    Labels& labels_;
    ui::Theme theme_;
    double step_;
    double near_; ///< px: from an axis to its numbers
    ui::TextStyle style_;
};

void draw_ticks(ui::Painter& painter, const Scene& scene, const ui::Box& box, const ui::PlaneCamera& camera,
                Labels& labels)
{
    const ui::LayerScope layer(painter, ui::Layer::Grid);
    const Ticks ticks(painter, scene, box, camera, labels);
    ticks.draw_normals();
    ticks.draw_shears();
}

constexpr double before_numbers = 1.0; ///< priority of an axis's title

double axis_head(const ui::Theme& theme) { return 9.0 * theme.symbol_scale(); }
/// From an axis to its title, clear of the head.
double beside_head(const ui::Theme& theme) { return 0.5 * axis_head(theme) + 3.0; }

void draw_normal_axis(ui::Painter& painter, const Scene& scene, const ui::Box& box, double y, Labels& labels)
{
    const ui::Theme theme = scene.look.full_theme();
    arrow(painter, {box.min.x, y}, {box.max.x, y}, theme.stroke(Role::Label), axis_head(theme));
    // Before words that lay on it the axis would be a minus sign.
    labels.obstacles().add_segment({box.min.x, y}, {box.max.x, y}, theme.stroke(Role::Label).width);
    const std::string title = axis_title(names_of(scene.document.subject).normal, scene.solution.unit);
    const ui::TextStyle style = theme.text(Role::Label);
    const double half = 0.5 * painter.measure(title, style).width + 1.0, away = beside_head(theme);
    labels.add_fixed({box.max.x - half, y}, {{0.0, -away}, {0.0, away}}, title, style, before_numbers);
}

/// Where the axis lies beside the box, its title alone.
void draw_shear_axis(ui::Painter& painter, const Scene& scene, const ui::Box& box, double zero, Labels& labels)
{
    const ui::Theme theme = scene.look.full_theme();
    const double x = std::clamp(zero, box.min.x, box.max.x), away = beside_head(theme);
    const bool is_down = scene.solution.rule == fm::ShearRule::TensorDown;
    const ui::Point top{x, box.min.y}, bottom{x, box.max.y};
    if (x == zero)
        arrow(painter, is_down ? top : bottom, is_down ? bottom : top, theme.stroke(Role::Label), axis_head(theme));
    const ui::TextStyle style = theme.text(Role::Label);
    const ui::Point inwards{0.0, (is_down ? -0.7 : 0.7) * style.size}; // half of the title's height
    labels.add_fixed((is_down ? bottom : top) + inwards, {{away, 0.0}, {-away, 0.0}},
                     axis_title(names_of(scene.document.subject).shear, scene.solution.unit), style, before_numbers);
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
    draw_ticks(painter, scene, box, camera, labels);
    draw_normal_axis(painter, scene, box, camera.to_sheet({0.0, 0.0}).y, labels);
    draw_shear_axis(painter, scene, box, camera.to_sheet({0.0, 0.0}).x, labels);
}

ui::Box write_rule(ui::Painter& painter, const Scene& scene, const ui::Box& box)
{
    ui::TextStyle faint = scene.look.full_theme().text(Role::FaintLabel);
    faint.size = scene.look.full_theme().type().small;
    std::size_t n_lines = 1;
    if (scene.look.both_rules) // side by side with the other one, both feet level
        for (const auto rule : {fm::ShearRule::ClockwiseUp, fm::ShearRule::TensorDown})
            n_lines = std::max(n_lines, lines_of(painter, shear_rule(scene, rule), faint, box.width()).size());
    return write_at_foot(painter, box, shear_rule(scene, scene.solution.rule), faint, n_lines);
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
    draw_extremes(d);
    if (d.radius() >= 4.0) draw_faces(d);
    if (d.radius() >= 4.0) draw_gauges(d);
    draw_mark(painter, scene, d.centre(), Handle::Centre, Role::Node);
    labels.add(d.centre(), {0.0, 1.0}, "C = " + scene.look.number(scene.solution.circle.centre), d.words(Role::Label),
               4.0);
    labels.draw(painter, d.theme);
    add_places(d, drawn);
}

} // namespace mohr
