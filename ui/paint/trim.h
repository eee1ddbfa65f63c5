#pragma once

#include "ui/paint/surface.h"

#include <vector>

namespace ui {

/// A stretch of a polyline that lies in a box, and its distance along the line from the line's beginning.
struct Stretch {
    std::vector<Point> points;
    double begin = 0.0;
};

/// The stretches of an open polyline inside the box, in order.
std::vector<Stretch> stretches_inside(std::span<const Point> points, const Box& box);

/// The polygon's part inside the box (Sutherland and Hodgman, CACM 17, 1974); pieces of a concave polygon stay joined
/// by edges that run along the box's border.
std::vector<Point> polygon_inside(std::span<const Point> polygon, const Box& box);

/// Draw only what lies inside `room`; shapes that lie inside it as a whole are handed on unchanged.
void stroke_trimmed(const Path& path, const Stroke& stroke, const Box& room, Surface& surface);
void fill_trimmed(std::span<const Point> polygon, Color color, const Box& room, Surface& surface);
void fill_region_trimmed(std::vector<std::vector<Point>> loops, Color color, const Box& room, Surface& surface);
void stroke_arc_trimmed(const Arc& arc, const Stroke& stroke, const Box& room, Surface& surface);
void fill_disc_trimmed(Point center, double radius, Color color, const Box& room, Surface& surface);

/// Points along the arc, no farther than `tolerance` from it between them; at most `max_points`.
std::vector<Point> arc_points(const Arc& arc, double tolerance, std::size_t max_points = 4096);

} // namespace ui
