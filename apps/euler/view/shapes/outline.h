#pragma once

#include "ui/paint/geometry.h"

#include <algorithm>
#include <span>

namespace euler {

/// Inside by the even-odd rule.
inline bool is_inside(std::span<const ui::Point> outline, ui::Point p)
{
    bool inside = false;
    for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const ui::Point a = outline[i], b = outline[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

/// \pre not empty
inline ui::Box bounds_of(std::span<const ui::Point> points)
{
    ui::Box box{points.front(), points.front()};
    for (const ui::Point p : points) box = ui::united(box, {p, p});
    return box;
}

inline double distance_to_segment(ui::Point p, ui::Point a, ui::Point b)
{
    const ui::Point along = b - a;
    const double square = ui::dot(along, along);
    const double t = square > 0.0 ? std::clamp(ui::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
    return ui::distance(p, a + t * along);
}

} // namespace euler
