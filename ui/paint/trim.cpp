#include "ui/paint/trim.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>

namespace ui {

namespace {

constexpr double largest_plain_radius = 4000.0; // [px]: larger ones are trimmed and drawn as lines
constexpr double flatness = 0.05;               // [px]

struct Span {
    double t0;
    double t1;
};

/// Liang and Barsky: the part of a segment inside a box, as parameters in [0, 1].
std::optional<Span> span_inside(Point a, Point b, const Box& box)
{
    Span span{0.0, 1.0};
    const Point d = b - a;
    const std::array<std::array<double, 2>, 4> sides = {
        {{-d.x, a.x - box.min.x}, {d.x, box.max.x - a.x}, {-d.y, a.y - box.min.y}, {d.y, box.max.y - a.y}}};
    for (const auto& [p, q] : sides) {
        if (p == 0.0) {
            if (q < 0.0) return std::nullopt;
        } else if (p < 0.0) {
            span.t0 = std::max(span.t0, q / p);
        } else {
            span.t1 = std::min(span.t1, q / p);
        }
    }
    if (span.t0 > span.t1) return std::nullopt;
    return span;
}

bool all_inside(std::span<const Point> points, const Box& box)
{
    return std::all_of(points.begin(), points.end(), [&](Point p) { return box.contains(p); });
}

struct ClipSide {
    Point normal; // kept: dot(normal, p) >= offset
    double offset;

    double depth(Point p) const { return dot(normal, p) - offset; }
};

std::vector<Point> cut(const std::vector<Point>& polygon, const ClipSide& side)
{
    std::vector<Point> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        const double da = side.depth(a), db = side.depth(b);
        if (da >= 0.0) kept.push_back(a);
        if ((da >= 0.0) != (db >= 0.0)) kept.push_back(a + (da / (da - db)) * (b - a));
    }
    return kept;
}

/// Angles in [from, to] at which the circle crosses the lines through the box's sides.
void add_crossings(std::vector<double>& angles, const Arc& circle, const Box& box, Span range)
{
    const auto add = [&](double angle) {
        constexpr double turn = 2.0 * std::numbers::pi;
        const double first = angle + turn * std::ceil((range.t0 - angle) / turn);
        for (double a = first; a < range.t1; a += turn) angles.push_back(a);
    };
    for (const double x : {box.min.x, box.max.x}) {
        const double c = (x - circle.center.x) / circle.radius;
        if (std::abs(c) > 1.0) continue;
        add(std::acos(c));
        add(-std::acos(c));
    }
    for (const double y : {box.min.y, box.max.y}) {
        const double s = (circle.center.y - y) / circle.radius;
        if (std::abs(s) > 1.0) continue;
        add(std::asin(s));
        add(std::numbers::pi - std::asin(s));
    }
}

/// The arcs of a large circle that lie inside the box.
std::vector<Arc> arcs_inside(const Arc& arc, const Box& box)
{
    const Span range{std::min(arc.start, arc.start + arc.sweep), std::max(arc.start, arc.start + arc.sweep)};
    std::vector<double> angles{range.t0, range.t1};
    add_crossings(angles, arc, box, range);
    std::sort(angles.begin(), angles.end());
    std::vector<Arc> inside;
    for (std::size_t i = 0; i + 1 < angles.size(); ++i) {
        const double sweep = angles[i + 1] - angles[i];
        if (sweep > 0.0 && box.contains(arc.at(angles[i] + 0.5 * sweep)))
            inside.push_back({arc.center, arc.radius, angles[i], sweep});
    }
    return inside;
}

bool is_near(Point center, double radius, const Box& box)
{
    const Point nearest{std::clamp(center.x, box.min.x, box.max.x), std::clamp(center.y, box.min.y, box.max.y)};
    return distance(center, nearest) <= radius;
}

} // namespace

std::vector<Stretch> stretches_inside(std::span<const Point> points, const Box& box)
{
    std::vector<Stretch> stretches;
    double walked = 0.0;
    bool continues = false; // the last stretch ends at points[i]
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const Point a = points[i], d = points[i + 1] - a;
        const double l = length(d);
        const auto span = span_inside(a, points[i + 1], box);
        if (span) {
            if (!continues || span->t0 > 0.0) stretches.push_back({{a + span->t0 * d}, walked + span->t0 * l});
            stretches.back().points.push_back(span->t1 < 1.0 ? a + span->t1 * d : points[i + 1]);
        }
        continues = span && span->t1 >= 1.0;
        walked += l;
    }
    return stretches;
}

std::vector<Point> polygon_inside(std::span<const Point> polygon, const Box& box)
{
    std::vector<Point> kept(polygon.begin(), polygon.end());
    const std::array<ClipSide, 4> sides = {
        {{{1.0, 0.0}, box.min.x}, {{-1.0, 0.0}, -box.max.x}, {{0.0, 1.0}, box.min.y}, {{0.0, -1.0}, -box.max.y}}};
    for (const ClipSide& side : sides) kept = cut(kept, side);
    return kept;
}

void stroke_trimmed(const Path& path, const Stroke& stroke, const Box& room, Surface& surface)
{
    if (all_inside(path.points, room)) return surface.stroke(path, stroke);
    std::vector<Point> open(path.points.begin(), path.points.end());
    if (path.ends == PathEnds::Closed) open.push_back(open.front());
    for (const Stretch& stretch : stretches_inside(open, room))
        surface.stroke({stretch.points, PathEnds::Open, path.dash_offset + stretch.begin}, stroke);
}

void fill_trimmed(std::span<const Point> polygon, Color color, const Box& room, Surface& surface)
{
    if (all_inside(polygon, room)) return surface.fill(polygon, color);
    const auto kept = polygon_inside(polygon, room);
    if (kept.size() >= 3) surface.fill(kept, color);
}

void fill_region_trimmed(std::vector<std::vector<Point>> loops, Color color, const Box& room, Surface& surface)
{
    for (std::vector<Point>& loop : loops)
        if (!all_inside(loop, room)) loop = polygon_inside(loop, room);
    if (loops.front().size() >= 3) surface.fill_region(loops, color);
}

void stroke_arc_trimmed(const Arc& arc, const Stroke& stroke, const Box& room, Surface& surface)
{
    if (!is_near(arc.center, arc.radius, room)) return;
    if (arc.radius <= largest_plain_radius) return surface.stroke_arc(arc, stroke);
    for (const Arc& part : arcs_inside(arc, room)) {
        const double walked = arc.radius * std::abs(part.start + (arc.sweep < 0.0 ? part.sweep : 0.0) - arc.start);
        auto points = arc_points(part, flatness);
        if (arc.sweep < 0.0) std::reverse(points.begin(), points.end());
        surface.stroke({points, PathEnds::Open, walked}, stroke);
    }
}

void fill_disc_trimmed(Point center, double radius, Color color, const Box& room, Surface& surface)
{
    if (!is_near(center, radius, room)) return;
    if (radius <= largest_plain_radius) return surface.fill_disc(center, radius, color);
    const Arc circle{center, radius, 0.0, 2.0 * std::numbers::pi};
    fill_trimmed(arc_points(circle, flatness, 16384), color, room, surface);
}

std::vector<Point> arc_points(const Arc& arc, double tolerance, std::size_t max_points)
{
    // The sagitta r (1 - cos(step / 2)) of each chord stays below the tolerance.
    const double step = 2.0 * std::acos(std::clamp(1.0 - tolerance / arc.radius, 0.0, 1.0));
    const double wanted = std::max(8.0 * std::abs(arc.sweep) / (2.0 * std::numbers::pi),
                                   step > 0.0 ? std::abs(arc.sweep) / step : 1e9);
    const auto n = static_cast<std::size_t>(std::ceil(std::clamp(wanted, 1.0, static_cast<double>(max_points - 1))));
    std::vector<Point> points(n + 1);
    for (std::size_t i = 0; i <= n; ++i)
        points[i] = arc.at(arc.start + arc.sweep * static_cast<double>(i) / static_cast<double>(n));
    return points;
}

} // namespace ui
