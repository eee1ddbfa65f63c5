#include "apps/mohr/view/curves_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "apps/mohr/document/degree.h"
#include "apps/mohr/view/axis.h"
#include "apps/mohr/view/circle_picture.h"
#include "apps/mohr/view/labels.h"
#include "apps/mohr/view/names.h"

namespace mohr {

namespace fm = femoop::mohr;
using ui::Role;

namespace {

/// Angles to the right, components up.
struct Graph {
    ui::Painter& painter;
    const Scene& scene;
    ui::Box box;
    double low, high;
    ui::Theme theme;
    Labels& labels;
    bool is_tight; ///< its numbers stand in a row above it

    double x(double degrees) const { return box.min.x + (degrees + 90.0) / 180.0 * box.width(); }
    double y(double value) const { return box.max.y - (value - low) / (high - low) * box.height(); }
    ui::Point at(double degrees, double value) const { return {x(degrees), y(value)}; }
    fm::CirclePoint on_face(double degrees) const
    {
        return fm::face_point(scene.solution.plane, degrees * degree, scene.solution.rule);
    }
};

/// [degrees] between two numbers of the angle, so that they do not touch.
int angle_step(const Graph& g, const ui::TextStyle& style)
{
    const double needed = g.painter.measure(g.scene.look.number(-90.0) + "°", style).width + 0.6 * style.size;
    for (const int step : {30, 45})
        if (g.box.width() * step / 180.0 > needed) return step;
    return 90;
}

void draw_grid(const Graph& g)
{
    const ui::LayerScope layer(g.painter, ui::Layer::Grid);
    ui::TextStyle style = g.theme.text(Role::FaintLabel, ui::Anchor::Top);
    style.size = g.theme.type().small;
    for (int t = -90; t <= 90; t += angle_step(g, style)) {
        g.painter.line({g.x(t), g.box.min.y}, {g.x(t), g.box.max.y},
                       g.theme.stroke(t == 0 ? Role::GridAxis : Role::Grid));
        g.painter.text({g.x(t), g.box.max.y + 4.0}, g.scene.look.number(t) + "°", style);
    }
    const double step = tick_step(g.box.height() / (g.high - g.low), 2.4 * style.size);
    style.anchor = ui::Anchor::Right;
    const int first = static_cast<int>(std::ceil(g.low / step)), last = static_cast<int>(std::floor(g.high / step));
    for (int i = first; i <= last && last - first < 100; ++i) {
        g.painter.line({g.box.min.x, g.y(i * step)}, {g.box.max.x, g.y(i * step)},
                       g.theme.stroke(i == 0 ? Role::GridAxis : Role::Grid));
        g.painter.text({g.box.min.x - 5.0, g.y(i * step)}, g.scene.look.number(i * step), style);
    }
}

void draw_lines(const Graph& g)
{
    constexpr int n = 90;
    std::vector<ui::Point> normal, shear;
    for (int i = 0; i <= n; ++i) {
        const double t = -90.0 + 180.0 * i / n;
        const auto [s, q] = g.on_face(t);
        normal.push_back(g.at(t, s));
        shear.push_back(g.at(t, q));
    }
    g.painter.polyline(normal, g.theme.stroke(Role::BendingMoment));
    g.painter.polyline(shear, g.theme.stroke(Role::ShearForce));
    g.labels.obstacles().add_polyline(normal, 2.0); // rather another line than these
    g.labels.obstacles().add_polyline(shear, 2.0);
}

/// Where the normal component is largest or least the shear vanishes.
void draw_special_angle(const Graph& g, std::optional<double> angle, const std::string& name)
{
    if (!angle) return;
    const double t = *angle / degree;
    g.painter.line({g.x(t), g.box.min.y}, {g.x(t), g.box.max.y}, g.theme.stroke(Role::Undeformed));
    ui::TextStyle style = g.theme.text(Role::FaintLabel);
    style.size = g.theme.type().small;
    g.labels.add({g.x(t), g.box.min.y + 0.6 * style.size}, {1.0, 0.0}, name, style, 2.0);
}

/// What is read at the cursor, in the colour of its curve.
struct Reading {
    std::string words;
    ui::TextStyle style;
};

/// One after the other above the curves, as broad as these at most.
void write_above(const Graph& g, const std::array<Reading, 2>& readings)
{
    constexpr double between = 1.2; // em
    double width = 0.0, x = g.box.min.x;
    for (const Reading& reading : readings)
        width += g.painter.measure(reading.words, reading.style).width + between * reading.style.size;
    for (auto [words, style] : readings) {
        style.size *= std::min(1.0, g.box.width() / width);
        style.anchor = ui::Anchor::BottomLeft;
        g.painter.text({x, g.box.min.y - 0.2 * style.size}, words, style);
        x += g.painter.measure(words, style).width + between * style.size;
    }
}

void draw_cursor(const Graph& g, Drawn& drawn)
{
    const double t = fm::as_direction(g.scene.solution.angle) / degree;
    const auto [s, q] = g.on_face(t);
    const Names names = names_of(g.scene.document.subject);
    g.painter.line({g.x(t), g.box.min.y}, {g.x(t), g.box.max.y}, g.theme.stroke(Role::LocalAxes));
    draw_mark(g.painter, g.scene, g.at(t, s), Handle::Cursor, Role::BendingMoment);
    draw_mark(g.painter, g.scene, g.at(t, q), Handle::Cursor, Role::ShearForce);
    const Reading normal{names.normal + " = " + g.scene.look.number(s), g.theme.text(Role::BendingMoment)};
    const Reading shear{names.shear + " = " + g.scene.look.number(q), g.theme.text(Role::ShearForce)};
    if (g.is_tight) write_above(g, {normal, shear});
    else {
        g.labels.add(g.at(t, s), {1.0, -0.6}, normal.words, normal.style, 6.0);
        g.labels.add(g.at(t, q), {1.0, 0.6}, shear.words, shear.style, 6.0);
    }
    drawn.places.push_back({Handle::Cursor, g.at(t, s)});
    drawn.places.push_back({Handle::Cursor, g.at(t, q)});
}

} // namespace

void draw_curves(ui::Painter& painter, const Scene& scene, const ui::Box& box, Drawn& drawn)
{
    const ui::Theme theme = scene.look.full_theme();
    constexpr double least_height = 7.5, least_width = 17.0; // em: for numbers beside the curves
    const Frame& frame = scene.frame;
    const double em = theme.type().normal;
    const bool is_tight = box.height() < least_height * em || box.width() < least_width * em;
    const ui::Box inner{{box.min.x + 5.0 * em, box.min.y + (is_tight ? 1.5 : 0.6) * em},
                        {box.max.x - 2.0 * em, box.max.y - 1.8 * em}};
    if (inner.width() < 20.0 || inner.height() < 20.0) return;
    Labels labels(inner, painter.fonts());
    const double low = std::min(frame.low, -frame.reach), high = std::max(frame.high, frame.reach);
    const Graph g{painter, scene, inner, low, high, theme, labels, is_tight};
    drawn.curves = {inner.min.x, inner.max.x};
    draw_grid(g);
    draw_lines(g);
    const auto& first = scene.solution.principal.angle;
    draw_special_angle(g, first, "θp1");
    if (first) draw_special_angle(g, fm::as_direction(*first + 0.5 * std::numbers::pi), "θp2");
    draw_special_angle(g, scene.solution.shear_angle, "θs");
    draw_cursor(g, drawn);
    labels.draw(painter, theme);
}

} // namespace mohr
