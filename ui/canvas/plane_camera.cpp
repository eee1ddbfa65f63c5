#include "ui/canvas/plane_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ui {

namespace {

struct Extent {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    double length() const { return high - low; }
    double middle() const { return 0.5 * low + 0.5 * high; }
};

/// Pixels left between two margins; a sheet smaller than its margins still shows something.
double room(double side, double before, double after) { return std::max(side - before - after, 0.1 * side); }

} // namespace

PlaneCamera::PlaneCamera(Point origin, double scale)
    : origin_(origin), scale_(std::clamp(scale, smallest_scale, largest_scale))
{}

void PlaneCamera::pan(Point shift)
{
    if (is_finite(shift)) origin_ = origin_ + shift;
}

void PlaneCamera::zoom(Point cursor, double factor)
{
    if (!std::isfinite(factor) || factor <= 0.0 || !is_finite(cursor)) return;
    const double wanted = std::clamp(scale_ * factor, smallest_scale, largest_scale);
    origin_ = cursor + (wanted / scale_) * (origin_ - cursor);
    scale_ = wanted;
}

void PlaneCamera::fit(std::span<const World2> points, Size sheet, const Margins& margins)
{
    Extent x, y;
    for (const World2 p : points) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
        x.add(p.x);
        y.add(p.y);
    }
    if (x.length() < 0.0 || sheet.width <= 0.0 || sheet.height <= 0.0) return;
    const double width = room(sheet.width, margins.left, margins.right);
    const double height = room(sheet.height, margins.top, margins.bottom);
    const double wanted = std::min(width / x.length(), height / y.length()); // infinite for a single place
    if (std::isfinite(wanted)) scale_ = std::clamp(wanted, smallest_scale, largest_scale);
    const Point middle{0.5 * (sheet.width + margins.left - margins.right),
                       0.5 * (sheet.height + margins.top - margins.bottom)};
    origin_ = {middle.x - scale_ * x.middle(), middle.y + scale_ * y.middle()};
}

} // namespace ui
