#include "apps/drawing/sketch/symbols.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace drawing {

namespace {

using std::numbers::pi;

void draw_end_on(Sketch& sketch, const Arrow& arrow)
{
    const double r = sketch.px(5.0);
    const ui::Stroke stroke = sketch.stroke(arrow.role);
    sketch.disc(arrow.head, r, sketch.theme().background());
    sketch.ring(arrow.head, r, stroke);
    if (arrow.facing > 0.0) {
        sketch.disc(arrow.head, 0.4 * r, stroke.color);
        return;
    }
    const double d = 0.7 * r;
    sketch.line(arrow.head - ui::Point{d, d}, arrow.head + ui::Point{d, d}, stroke);
    sketch.line(arrow.head - ui::Point{d, -d}, arrow.head + ui::Point{d, -d}, stroke);
}

} // namespace

void arrow_head(Sketch& sketch, ui::Point tip, ui::Point direction, double length, ui::Color color)
{
    const ui::Point d = ui::direction(direction);
    const ui::Point n = ui::left_normal(d);
    const ui::Point back = tip - length * d;
    if (sketch.is_reduced()) // too small for a notch to be seen
        return sketch.polygon({tip, back + 0.36 * length * n, back - 0.36 * length * n}, color);
    sketch.polygon({tip, back + 0.36 * length * n, back + 0.12 * length * d, back - 0.36 * length * n}, color);
}

void draw(Sketch& sketch, const Arrow& arrow)
{
    const double length = ui::distance(arrow.tail, arrow.head);
    if (length < sketch.px(4.0)) {
        if (std::abs(arrow.facing) > 0.9) draw_end_on(sketch, arrow);
        return;
    }
    const ui::Point d = ui::direction(arrow.head - arrow.tail);
    const double head = std::min(sketch.px(arrow.head_size), 0.6 * length);
    const ui::Stroke stroke = arrow.stroke.value_or(sketch.stroke(arrow.role));
    sketch.line(arrow.tail, arrow.head - 0.8 * head * d, stroke);
    for (int i = 0; i < arrow.n_heads; ++i) {
        const double back = 0.8 * head * i;
        if (back + head <= length) arrow_head(sketch, arrow.head - back * d, d, head, stroke.color);
    }
}

std::vector<ui::Point> arc_in(const SymbolFrame& frame, double radius, double start, double sweep)
{
    const int n = std::max(6, static_cast<int>(std::ceil(std::abs(sweep) / (pi / 20))));
    std::vector<ui::Point> points;
    points.reserve(static_cast<std::size_t>(n) + 1);
    for (int i = 0; i <= n; ++i) {
        const double angle = start + sweep * i / n;
        points.push_back(frame(radius * std::cos(angle), radius * std::sin(angle)));
    }
    return points;
}

void draw(Sketch& sketch, const CurvedArrow& arrow)
{
    const double sense = arrow.sense >= 0.0 ? 1.0 : -1.0;
    const double r = sketch.px(arrow.radius);
    const double head = sketch.px(9.0);
    // The line ends inside the head, whose tip lies at the end of the sweep.
    const double start = sense > 0.0 ? arrow.start : pi - arrow.start;
    const std::vector<ui::Point> points = arc_in(arrow.frame, r, start, sense * (arrow.sweep - 0.7 * head / r));
    ui::Stroke stroke = sketch.stroke(arrow.role);
    stroke.dash = arrow.dash;
    sketch.polyline(points, stroke);
    const double end = start + sense * arrow.sweep;
    const ui::Point tip = arrow.frame(r * std::cos(end), r * std::sin(end));
    const double before = end - sense * head / r;
    arrow_head(sketch, tip, tip - arrow.frame(r * std::cos(before), r * std::sin(before)), head, stroke.color);
}

std::vector<ui::Point> area_of(const Sketch& sketch, const CurvedArrow& arrow)
{
    const double sense = arrow.sense >= 0.0 ? 1.0 : -1.0, half = sketch.px(4.0);
    const double start = sense > 0.0 ? arrow.start : pi - arrow.start;
    const auto arc = [&](double radius) { return arc_in(arrow.frame, radius, start, sense * arrow.sweep); };
    std::vector<ui::Point> area = arc(sketch.px(arrow.radius) + half);
    const std::vector<ui::Point> inner = arc(sketch.px(arrow.radius) - half);
    area.insert(area.end(), inner.rbegin(), inner.rend());
    return area;
}

void draw_ground(Sketch& sketch, const SymbolFrame& frame, double half)
{
    const ui::Stroke stroke = sketch.stroke(ui::Role::Support);
    sketch.line(frame(-half, 0.0), frame(half, 0.0), stroke);
    const double depth = sketch.px(6.0);
    const int n = std::max(3, static_cast<int>(std::lround(2.0 * half / sketch.px(5.5))));
    const double step = 2.0 * half / n;
    for (int i = 0; i < n; ++i) {
        const double x = -half + (i + 1) * step;
        sketch.line(frame(x, 0.0), frame(x - 0.9 * depth, -depth), sketch.thin(ui::Role::Support), Clearance::None);
    }
    sketch.keep_clear({frame(-half - depth, -depth), frame(half, -depth), frame(half, 0.0), frame(-half, 0.0)});
}

void draw_zigzag(Sketch& sketch, const SymbolFrame& frame, double length, double half_width)
{
    constexpr int n_teeth = 4;
    const double lead = 0.15 * length;
    const double step = (length - 2.0 * lead) / (2 * n_teeth);
    std::vector<ui::Point> points{frame(0.0, 0.0), frame(lead, 0.0)};
    for (int i = 0; i < 2 * n_teeth; ++i) {
        const double side = i % 2 == 0 ? 1.0 : -1.0;
        points.push_back(frame(lead + (i + 0.5) * step, side * half_width));
    }
    points.push_back(frame(length - lead, 0.0));
    points.push_back(frame(length, 0.0));
    sketch.polyline(points, sketch.stroke(ui::Role::Spring));
}

void draw_spiral(Sketch& sketch, const SymbolFrame& frame, double radius)
{
    constexpr double n_turns = 2.0;
    constexpr int n = 60;
    std::vector<ui::Point> points;
    for (int i = 0; i <= n; ++i) {
        const double t = static_cast<double>(i) / n;
        const double r = radius * (0.12 + 0.88 * t);
        const double angle = -2.0 * pi * n_turns * (1.0 - t);
        points.push_back(frame(r * std::cos(angle), r * std::sin(angle)));
    }
    sketch.polyline(points, sketch.stroke(ui::Role::Spring));
}

} // namespace drawing
