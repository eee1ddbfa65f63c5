#include "ui/paint/mesh/simplified.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
        const double along = dot(axis_, d), across = cross(axis_, d);
        if (along <= 0.0 || across < low_ * along || across > high_ * along) return false;
        narrow(along, across, l);
        return true;
    }

private:
    /// To the tangents of the circle about a point, as far as they lie ahead.
    void narrow(double along, double across, double l)
    {
        const double ahead = std::sqrt(l * l - tolerance_ * tolerance_);
        const double left = along * ahead + across * tolerance_, right = along * ahead - across * tolerance_;
        if (left > 0.0) low_ = std::max(low_, (across * ahead - along * tolerance_) / left);
        if (right > 0.0) high_ = std::min(high_, (across * ahead + along * tolerance_) / right);
    }

    Point apex_;
    double tolerance_;
    Point axis_{};
    bool has_axis_ = false;
    double farthest_ = 0.0;
    double low_ = -std::numeric_limits<double>::infinity(); // slopes against the axis
    double high_ = std::numeric_limits<double>::infinity();
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
