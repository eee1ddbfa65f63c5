#pragma once

#include <algorithm>
#include <cmath>

namespace ui {

/// A place on a sheet in logical pixels: x to the right, y DOWN, the origin at the sheet's top left corner.
/// One logical pixel is 1/96 inch on paper and `scale` physical pixels on a screen.
struct Point {
    double x = 0.0;
    double y = 0.0;

    friend bool operator==(const Point&, const Point&) = default;
};

inline Point operator+(Point a, Point b) { return {a.x + b.x, a.y + b.y}; }
inline Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y}; }
inline Point operator-(Point a) { return {-a.x, -a.y}; }
inline Point operator*(double k, Point a) { return {k * a.x, k * a.y}; }
inline Point operator*(Point a, double k) { return k * a; }
inline Point operator/(Point a, double k) { return {a.x / k, a.y / k}; }

inline double dot(Point a, Point b) { return a.x * b.x + a.y * b.y; }
/// z component of a x b. With y down it is positive when the turn from a to b is clockwise as seen.
inline double cross(Point a, Point b) { return a.x * b.y - a.y * b.x; }
inline double length(Point a) { return std::sqrt(dot(a, a)); }
inline double distance(Point a, Point b) { return length(b - a); }
inline bool is_finite(Point a) { return std::isfinite(a.x) && std::isfinite(a.y); }
/// a turned by a quarter counter-clockwise as seen on the sheet (y down).
inline Point left_normal(Point a) { return {a.y, -a.x}; }
/// Unit vector along a; (1, 0) where a has no length.
inline Point direction(Point a)
{
    const double l = length(a);
    return l > 0.0 ? a / l : Point{1.0, 0.0};
}

struct Size {
    double width = 0.0;
    double height = 0.0;

    friend bool operator==(const Size&, const Size&) = default;
};

inline Size operator*(double k, Size s) { return {k * s.width, k * s.height}; }

/// Rectangle with sides along the axes; min is its top left corner (y down). Empty when max lies before min.
struct Box {
    Point min;
    Point max;

    double width() const { return max.x - min.x; }
    double height() const { return max.y - min.y; }
    Size size() const { return {width(), height()}; }
    Point center() const { return 0.5 * (min + max); }
    bool is_empty() const { return max.x < min.x || max.y < min.y; }
    bool contains(Point p) const { return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y; }
    bool contains(const Box& b) const { return contains(b.min) && contains(b.max); }
    /// True when the interiors share a point; boxes that only touch do not overlap.
    bool overlaps(const Box& b) const
    {
        return min.x < b.max.x && b.min.x < max.x && min.y < b.max.y && b.min.y < max.y;
    }
    Box grown(double margin) const { return {{min.x - margin, min.y - margin}, {max.x + margin, max.y + margin}}; }

    friend bool operator==(const Box&, const Box&) = default;
};

inline Box box_at(Point top_left, Size size) { return {top_left, {top_left.x + size.width, top_left.y + size.height}}; }

inline Box intersection(const Box& a, const Box& b)
{
    return {{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)},
            {std::min(a.max.x, b.max.x), std::min(a.max.y, b.max.y)}};
}

/// The smallest box that holds both.
inline Box united(const Box& a, const Box& b)
{
    return {{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)},
            {std::max(a.max.x, b.max.x), std::max(a.max.y, b.max.y)}};
}

} // namespace ui
