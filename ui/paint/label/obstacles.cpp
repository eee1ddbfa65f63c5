#include "ui/paint/label/obstacles.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/paint/label/cells.h"

namespace ui {

namespace {

constexpr double obstacle_cell_side = 32.0; // [px]: about the size of a label
constexpr double most_obstacle_cells = 512.0;

} // namespace

LabelObstacles::LabelObstacles(const Box& room)
    : room_(room),
      n_columns_(n_cells(room.width(), obstacle_cell_side, most_obstacle_cells)),
      n_rows_(n_cells(room.height(), obstacle_cell_side, most_obstacle_cells)),
      cells_(static_cast<std::size_t>(n_columns_) * static_cast<std::size_t>(n_rows_))
{}

/// What lies outside the room is counted to the cells along its border.
LabelObstacles::CellRange LabelObstacles::cells(const Box& box) const
{
    const auto at = [](double place, int n) {
        return static_cast<int>(std::clamp(std::floor(place / obstacle_cell_side), 0.0, static_cast<double>(n - 1)));
    };
    return {at(box.min.x - room_.min.x, n_columns_), at(box.min.y - room_.min.y, n_rows_),
            at(box.max.x - room_.min.x, n_columns_), at(box.max.y - room_.min.y, n_rows_)};
}

void LabelObstacles::add_segment(Point a, Point b, double width, Firmness firmness)
{
    if (!is_finite(a) || !is_finite(b)) return;
    const auto index = static_cast<std::uint32_t>(segments_.size());
    const Box bounds = united({a, a}, {b, b}).grown(0.5 * width + 1e-6); // never without area
    segments_.push_back({a, b, 0.5 * width, firmness, bounds});
    const CellRange range = cells(bounds);
    const bool is_in_one_cell = range.x0 == range.x1 && range.y0 == range.y1;
    if (is_in_one_cell) return cell(range.x0, range.y0).segments.push_back(index);
    for (int y = range.y0; y <= range.y1; ++y) {
        for (int x = range.x0; x <= range.x1; ++x) {
            const Point corner{room_.min.x + x * obstacle_cell_side, room_.min.y + y * obstacle_cell_side};
            const bool is_border = x == 0 || y == 0 || x == n_columns_ - 1 || y == n_rows_ - 1;
            const OrientedBox square({corner.x + 0.5 * obstacle_cell_side, corner.y + 0.5 * obstacle_cell_side},
                                     {obstacle_cell_side, obstacle_cell_side});
            if (is_border || square.grown(0.5 * width + 1e-6).meets_segment(a, b)) cell(x, y).segments.push_back(index);
        }
    }
}

void LabelObstacles::add_polyline(std::span<const Point> points, double width, Firmness firmness)
{
    for (std::size_t i = 0; i + 1 < points.size(); ++i) add_segment(points[i], points[i + 1], width, firmness);
}

void LabelObstacles::add_polygon(std::span<const Point> points, Firmness firmness)
{
    if (points.size() < 3 || !std::all_of(points.begin(), points.end(), is_finite)) return;
    add_polyline(points, 0.0, firmness);
    add_segment(points.back(), points.front(), 0.0, firmness);
    add_inside(points, firmness);
}

void LabelObstacles::add_inside(std::span<const Point> points, Firmness firmness)
{
    if (points.size() < 3 || !std::all_of(points.begin(), points.end(), is_finite)) return;
    Box bounds{points[0], points[0]};
    for (const Point p : points) bounds = united(bounds, {p, p});
    const auto index = static_cast<std::uint32_t>(polygons_.size());
    polygons_.push_back({corners_.size(), points.size(), bounds, firmness});
    corners_.insert(corners_.end(), points.begin(), points.end());
    const CellRange range = cells(bounds);
    for (int y = range.y0; y <= range.y1; ++y)
        for (int x = range.x0; x <= range.x1; ++x) cell(x, y).polygons.push_back(index);
}

void LabelObstacles::add_box(const Box& box, Firmness firmness)
{
    const std::array<Point, 4> corners = {box.min, Point{box.max.x, box.min.y}, box.max, Point{box.min.x, box.max.y}};
    add_polygon(corners, firmness);
}

void LabelObstacles::add_disc(Point center, double radius, Firmness firmness)
{
    add_box(Box{center, center}.grown(radius), firmness);
}

/// Even-odd rule.
bool LabelObstacles::contains(const Polygon& polygon, Point p) const
{
    if (!polygon.bounds.contains(p)) return false;
    bool is_inside = false;
    const Point* corner = corners_.data() + polygon.begin;
    for (std::size_t i = 0, j = polygon.count - 1; i < polygon.count; j = i++) {
        const Point a = corner[i], b = corner[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) is_inside = !is_inside;
    }
    return is_inside;
}

Ground LabelObstacles::ground_of(const OrientedBox& box) const
{
    Ground ground = Ground::Free;
    const auto cover = [&](Firmness firmness) { ground = firmness == Firmness::Hard ? Ground::Taken : Ground::Soft; };
    const auto adds = [&](Firmness firmness) { return firmness == Firmness::Hard || ground == Ground::Free; };
    const Box bounds = box.bounds();
    const CellRange range = cells(bounds);
    for (int y = range.y0; y <= range.y1; ++y) {
        for (int x = range.x0; x <= range.x1; ++x) {
            for (const std::uint32_t i : cell(x, y).segments) {
                const Segment& s = segments_[i];
                if (!adds(s.firmness) || !s.bounds.overlaps(bounds)) continue;
                if (box.grown(s.half_width).meets_segment(s.a, s.b)) cover(s.firmness);
                if (ground == Ground::Taken) return ground;
            }
        }
    }
    // A box that meets no outline lies inside a polygon or outside as a whole.
    return std::max(ground, ground_inside(box.center));
}

Ground LabelObstacles::ground_inside(Point p) const
{
    Ground ground = Ground::Free;
    const CellRange range = cells({p, p});
    for (const std::uint32_t i : cell(range.x0, range.y0).polygons) {
        const Ground inside = polygons_[i].firmness == Firmness::Hard ? Ground::Taken : Ground::Soft;
        if (inside > ground && contains(polygons_[i], p)) ground = inside;
        if (ground == Ground::Taken) break;
    }
    return ground;
}

} // namespace ui
