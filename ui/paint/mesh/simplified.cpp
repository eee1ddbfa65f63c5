#include "ui/paint/mesh/simplified.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

/// Directions from a point that pass all points seen so far within a tolerance.
class Cone {
public:
    Cone(Point apex, double tolerance) : apex_(apex), tolerance_(tolerance) {}

    /// Narrows the cone; false, and the cone is done with, when the line through the apex and p misses a point before.
    bool take(Point p)
    {
        const Point d = p - apex_;
        const double l = length(d);
        if (l < farthest_) return false; // turned back
        farthest_ = l;
        if (l <= tolerance_) return true; // every direction passes
        if (!has_axis_) {
            axis_ = d / l;
            has_axis_ = true;
        }
        if (dot(axis_, d) <= 0.0) return false;
        const double angle = std::atan2(cross(axis_, d), dot(axis_, d)), half = std::asin(tolerance_ / l);
        if (angle < low_ || angle > high_) return false;
        low_ = std::max(low_, angle - half);
        high_ = std::min(high_, angle + half);
        return true;
    }

private:
    Point apex_;
    double tolerance_;
    Point axis_{};
    bool has_axis_ = false;
    double farthest_ = 0.0;
    double low_ = -2.0; // [rad] from the axis; wider than any angle that is let through
    double high_ = 2.0;
};

} // namespace

std::vector<Point> simplified(std::span<const Point> line, double tolerance)
{
    if (line.size() < 3) return {line.begin(), line.end()};
    std::vector<Point> kept{line.front()};
    Cone cone(line.front(), tolerance);
    for (std::size_t i = 1; i < line.size(); ++i) {
        if (cone.take(line[i])) continue;
        kept.push_back(line[i - 1]);
        cone = Cone(line[i - 1], tolerance);
        cone.take(line[i]);
    }
    kept.push_back(line.back());
    return kept;
}

} // namespace ui
