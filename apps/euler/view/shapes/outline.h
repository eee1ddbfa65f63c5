#pragma once

#include "ui/paint/geometry.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace euler {

/// An area of the sheet: its outline, and then its holes.
using Region = std::vector<std::vector<ui::Point>>;

/// Does something with both ends of every side, of the outline and of the holes.
template <class Visit> void for_each_side(const Region& region, const Visit& visit)
{
    for (const std::vector<ui::Point>& loop : region)
        for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) visit(loop[j], loop[i]);
}

/// In the outline and in no hole.
inline bool is_inside(const Region& region, ui::Point p)
{
    bool inside = false;
    for_each_side(region, [&](ui::Point a, ui::Point b) {
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    });
    return inside;
}

/// \pre not empty
inline ui::Box bounds_of(std::span<const ui::Point> points)
{
    ui::Box box{points.front(), points.front()};
    for (const ui::Point p : points) box = ui::united(box, {p, p});
    return box;
}
inline ui::Box bounds_of(const Region& region) { return bounds_of(std::span(region.front())); }

inline double distance_to_segment(ui::Point p, ui::Point a, ui::Point b)
{
    const ui::Point along = b - a;
    const double square = ui::dot(along, along);
    const double t = square > 0.0 ? std::clamp(ui::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
    return ui::distance(p, a + t * along);
}

} // namespace euler
