#include "apps/drawing/geometry/projection.h"

#include <cmath>

namespace drawing {

SymbolFrame SymbolFrame::turned(double angle) const
{
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {origin, c * x + s * y, -s * x + c * y};
}

ui::Point Projection::operator()(const Eigen::Vector3d& place) const
{
    if (const auto* plane = std::get_if<ui::PlaneCamera>(&camera_))
        return plane->to_sheet({place.x(), place.y()}) + shift_;
    return std::get<ui::OrbitCamera>(camera_).to_sheet({place.x(), place.y(), place.z()}) + shift_;
}

ui::Point Projection::direction(const Eigen::Vector3d& unit) const
{
    if (is_plane()) return {unit.x(), -unit.y()};
    const auto& orbit = std::get<ui::OrbitCamera>(camera_);
    const ui::World3 right = orbit.right();
    const ui::World3 up = orbit.up();
    return {unit.x() * right.x + unit.y() * right.y + unit.z() * right.z,
            -(unit.x() * up.x + unit.y() * up.y + unit.z() * up.z)};
}

double Projection::scale() const
{
    return std::visit([](const auto& camera) { return camera.scale(); }, camera_);
}

double Projection::nearness(const Eigen::Vector3d& place) const
{
    if (is_plane()) return 0.0;
    return std::get<ui::OrbitCamera>(camera_).nearness({place.x(), place.y(), place.z()});
}

Eigen::Vector3d Projection::place_at(ui::Point on_sheet, double nearness) const
{
    if (const auto* const plane = std::get_if<ui::PlaneCamera>(&camera_)) {
        const ui::World2 place = plane->to_world(on_sheet - shift_);
        return {place.x, place.y, 0.0};
    }
    const ui::World3 place = std::get<ui::OrbitCamera>(camera_).to_world(on_sheet - shift_, nearness);
    return {place.x, place.y, place.z};
}

std::optional<double> Projection::nearest_share(const Eigen::Vector3d& start, const Eigen::Vector3d& end,
                                                ui::Point at) const
{
    constexpr double shortest = 1.0; // [px]
    const ui::Point from = (*this)(start);
    const ui::Point run = (*this)(end)-from;
    const double square = dot(run, run);
    if (square < shortest * shortest) return std::nullopt;
    return dot(at - from, run) / square;
}

Eigen::Vector3d Projection::toward_eye() const
{
    if (is_plane()) return Eigen::Vector3d::UnitZ();
    const ui::World3 eye = std::get<ui::OrbitCamera>(camera_).toward_eye();
    return {eye.x, eye.y, eye.z};
}

} // namespace drawing
