#pragma once

#include "ui/paint/geometry.h"

#include <array>

namespace ui {

/// A rectangle turned about its middle.
struct OrientedBox {
    Point center;
    Point half;            ///< half its width and half its height
    Point along{1.0, 0.0}; ///< unit vector of its width

    OrientedBox(Point middle, Size size, double rotation = 0.0)
        : center(middle), half{0.5 * size.width, 0.5 * size.height}
    {
        if (rotation != 0.0) along = {std::cos(rotation), -std::sin(rotation)};
    }

    bool is_level() const { return along == Point{1.0, 0.0}; }
    Point across() const { return -left_normal(along); }
    OrientedBox grown(double margin) const
    {
        OrientedBox box = *this;
        box.half = box.half + Point{margin, margin};
        return box;
    }
    /// p in the box's own frame: origin at its middle, x along its width.
    Point to_own(Point p) const { return {dot(p - center, along), dot(p - center, across())}; }
    Point from_own(Point p) const { return center + p.x * along + p.y * across(); }
    Box bounds() const;
    std::array<Point, 4> corners() const;
    /// The point of the box that is nearest to p; p itself when it lies inside.
    Point nearest(Point p) const;
    bool overlaps(const OrientedBox& other) const;
    /// Whether some point of the segment lies inside.
    bool meets_segment(Point a, Point b) const;
};

} // namespace ui
