#include "ui/paint/painter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace ui {

namespace {

constexpr double plate_padding_of_em = 0.15;

bool is_drawable(const Stroke& stroke) { return std::isfinite(stroke.width) && stroke.width >= 0.0; }

bool is_drawable(std::span<const Point> points) { return std::all_of(points.begin(), points.end(), is_finite); }

bool is_drawable(Point center, double radius) { return is_finite(center) && std::isfinite(radius) && radius >= 0.0; }

bool is_drawable(const TextStyle& style)
{
    return std::isfinite(style.size) && style.size > 0.0 && std::isfinite(style.rotation);
}

std::array<Point, 4> corners_of(const Box& box)
{
    return {box.min, Point{box.max.x, box.min.y}, box.max, Point{box.min.x, box.max.y}};
}

} // namespace

Painter::Painter(Size size, const Fonts& fonts) : picture_(size), fonts_(&fonts)
{
    clips_.push_back(sheet());
    picture_.clips_.push_back(sheet());
}

void Painter::push_clip(const Box& box)
{
    clips_.push_back(intersection(clips_.back(), box));
    picture_.clips_.push_back(clips_.back());
}

void Painter::pop_clip()
{
    if (clips_.size() < 2) throw std::logic_error("Painter::pop_clip: no clip was pushed");
    clips_.pop_back();
    picture_.clips_.push_back(clips_.back());
}

template <class What> void Painter::add(What&& what)
{
    picture_.shapes_.push_back({layer_, picture_.clips_.size() - 1, std::forward<What>(what)});
}

void Painter::line(Point a, Point b, const Stroke& stroke) { polyline({a, b}, stroke); }

void Painter::polyline(std::span<const Point> points, const Stroke& stroke, PathEnds ends)
{
    if (!is_drawable(points) || !is_drawable(stroke)) return refuse();
    if (points.size() < 2 || stroke.width == 0.0) return;
    add(Picture::Line{picture_.store(points), ends, stroke});
}

void Painter::polyline(std::initializer_list<Point> points, const Stroke& stroke, PathEnds ends)
{
    polyline(std::span(points.begin(), points.size()), stroke, ends);
}

void Painter::polygon(std::span<const Point> points, Color fill)
{
    if (!is_drawable(points)) return refuse();
    if (points.size() < 3) return;
    add(Picture::Polygon{picture_.store(points), fill});
}

void Painter::polygon(std::initializer_list<Point> points, Color fill)
{
    polygon(std::span(points.begin(), points.size()), fill);
}

void Painter::region(std::span<const std::vector<Point>> loops, Color fill)
{
    if (!std::all_of(loops.begin(), loops.end(), [](const auto& loop) { return is_drawable(loop); })) return refuse();
    if (loops.empty() || loops.front().size() < 3) return;
    Picture::Region region{{}, fill};
    for (const std::vector<Point>& loop : loops) region.loops.push_back(picture_.store(loop));
    add(std::move(region));
}

void Painter::rectangle(const Box& box, Color fill)
{
    if (is_finite(box.min) && is_finite(box.max) && box.is_empty()) return;
    polygon(corners_of(box), fill);
}

void Painter::circle(Point center, double radius, const Stroke& stroke)
{
    arc({.center = center, .radius = radius, .start = 0.0, .sweep = 2.0 * std::numbers::pi}, stroke);
}

void Painter::disc(Point center, double radius, Color fill)
{
    if (!is_drawable(center, radius)) return refuse();
    if (radius == 0.0) return;
    add(Picture::Disc{center, radius, fill});
}

void Painter::arc(const Arc& arc, const Stroke& stroke)
{
    const bool has_angles = std::isfinite(arc.start) && std::isfinite(arc.sweep);
    if (!is_drawable(arc.center, arc.radius) || !has_angles || !is_drawable(stroke)) return refuse();
    if (arc.radius == 0.0 || arc.sweep == 0.0 || stroke.width == 0.0) return;
    Arc once_around = arc;
    once_around.start = std::remainder(arc.start, 2.0 * std::numbers::pi);
    once_around.sweep = std::clamp(arc.sweep, -2.0 * std::numbers::pi, 2.0 * std::numbers::pi);
    add(Picture::ArcLine{once_around, stroke});
}

void Painter::photo(std::shared_ptr<const Photo> photo, const ImagePlace& place)
{
    const bool is_placed = is_finite(place.corner) && is_finite(place.right) && is_finite(place.down);
    if (!is_placed || !(place.opacity >= 0.0 && place.opacity <= 1.0)) return refuse();
    const bool is_seen = place.opacity > 0.0 && cross(place.right, place.down) != 0.0;
    if (photo && is_seen) add(Picture::PlacedPhoto{std::move(photo), place});
}

void Painter::text(Point at, std::string_view utf8, const TextStyle& style)
{
    if (!is_finite(at) || !is_drawable(style)) return refuse();
    if (utf8.empty()) return;
    if (style.plate) draw_plate(at, utf8, style);
    const Picture::Range bytes{picture_.bytes_.size(), utf8.size()};
    picture_.bytes_ += utf8;
    add(Picture::Text{at, bytes, style});
}

void Painter::draw_plate(Point at, std::string_view utf8, const TextStyle& style)
{
    auto corners = text_corners(*fonts_, at, utf8, style);
    const double padding = plate_padding_of_em * style.size;
    const Point along = padding * direction(corners[1] - corners[0]);
    const Point down = padding * direction(corners[3] - corners[0]);
    corners[0] = corners[0] - along - down;
    corners[1] = corners[1] + along - down;
    corners[2] = corners[2] + along + down;
    corners[3] = corners[3] - along + down;
    polygon(corners, *style.plate);
}

} // namespace ui
