#include "ui/paint/label/oriented_box.h"

#include <algorithm>

namespace ui {

namespace {

/// Half the box's extent along a unit vector.
double reach_along(const OrientedBox& box, Point axis)
{
    return box.half.x * std::abs(dot(box.along, axis)) + box.half.y * std::abs(dot(box.across(), axis));
}

bool is_separating(Point axis, const OrientedBox& a, const OrientedBox& b)
{
    return std::abs(dot(b.center - a.center, axis)) >= reach_along(a, axis) + reach_along(b, axis);
}

} // namespace

Box OrientedBox::bounds() const
{
    if (is_level()) return {center - half, center + half};
    const Point reach{reach_along(*this, {1.0, 0.0}), reach_along(*this, {0.0, 1.0})};
    return {center - reach, center + reach};
}

std::array<Point, 4> OrientedBox::corners() const
{
    return {from_own({-half.x, -half.y}), from_own({half.x, -half.y}), from_own(half), from_own({-half.x, half.y})};
}

Point OrientedBox::nearest(Point p) const
{
    const Point own = to_own(p);
    return from_own({std::clamp(own.x, -half.x, half.x), std::clamp(own.y, -half.y, half.y)});
}

bool OrientedBox::overlaps(const OrientedBox& other) const
{
    return !is_separating(along, *this, other) && !is_separating(across(), *this, other) &&
           !is_separating(other.along, *this, other) && !is_separating(other.across(), *this, other);
}

bool OrientedBox::meets_segment(Point a, Point b) const
{
    const Point p = to_own(a), d = to_own(b) - p;
    double t0 = 0.0, t1 = 1.0;
    const auto cut = [&](double start, double step, double limit) { // -limit < start + t step < limit
        if (step == 0.0) return std::abs(start) < limit;
        const double u = (-limit - start) / step, v = (limit - start) / step;
        t0 = std::max(t0, std::min(u, v));
        t1 = std::min(t1, std::max(u, v));
        return t0 < t1;
    };
    return cut(p.x, d.x, half.x) && cut(p.y, d.y, half.y);
}

} // namespace ui
