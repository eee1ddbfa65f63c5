#include "ui/canvas/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace ui {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double turn_per_pixel = pi / 500.0;

double dot(World3 a, World3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

World3 combined(double a, World3 u, double b, World3 v, double c, World3 w)
{
    return {a * u.x + b * v.x + c * w.x, a * u.y + b * v.y + c * w.y, a * u.z + b * v.z + c * w.z};
}

} // namespace

void OrbitCamera::look(StandardView view)
{
    switch (view) {
    case StandardView::Isometric: return look(-0.25 * pi, std::atan(1.0 / std::numbers::sqrt2));
    case StandardView::Front: return look(-0.5 * pi, 0.0);
    case StandardView::Side: return look(0.0, 0.0);
    case StandardView::Top: return look(-0.5 * pi, 0.5 * pi);
    }
}

void OrbitCamera::look(double azimuth, double elevation)
{
    if (!std::isfinite(azimuth) || !std::isfinite(elevation)) return;
    azimuth_ = std::remainder(azimuth, 2.0 * pi);
    elevation_ = std::clamp(elevation, -0.5 * pi, 0.5 * pi);
}

void OrbitCamera::orbit(Point drag, World3 pivot)
{
    const Point before = to_sheet(pivot);
    look(azimuth_ - turn_per_pixel * drag.x, elevation_ + turn_per_pixel * drag.y);
    pan(before - to_sheet(pivot));
}

void OrbitCamera::fit(std::span<const World3> points, Size sheet, const Margins& margins)
{
    std::vector<World2> on_sheet;
    on_sheet.reserve(points.size());
    for (const World3 p : points) on_sheet.push_back(on_plane(p));
    plane_.fit(on_sheet, sheet, margins);
}

World3 OrbitCamera::right() const { return {-std::sin(azimuth_), std::cos(azimuth_), 0.0}; }

World3 OrbitCamera::up() const
{
    const double s = std::sin(elevation_);
    return {-s * std::cos(azimuth_), -s * std::sin(azimuth_), std::cos(elevation_)};
}

World3 OrbitCamera::toward_eye() const
{
    const double c = std::cos(elevation_);
    return {c * std::cos(azimuth_), c * std::sin(azimuth_), std::sin(elevation_)};
}

World2 OrbitCamera::on_plane(World3 p) const { return {dot(right(), p), dot(up(), p)}; }

double OrbitCamera::nearness(World3 p) const { return dot(toward_eye(), p); }

World3 OrbitCamera::to_world(Point p, double nearness) const
{
    const World2 on_plane = plane_.to_world(p);
    return combined(on_plane.x, right(), on_plane.y, up(), nearness, toward_eye());
}

} // namespace ui
