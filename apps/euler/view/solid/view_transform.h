#pragma once

#include "topology/geometry/vector.h"
#include "ui/canvas/orbit_camera.h"

namespace euler {

/// A camera at rest, with what every point needs of it at hand.
class ViewTransform {
public:
    explicit ViewTransform(const ui::OrbitCamera& camera)
        : right_(vector(camera.right())),
          up_(vector(camera.up())),
          toward_eye_(vector(camera.toward_eye())),
          origin_(camera.to_sheet({})),
          scale_(camera.scale())
    {}

    ui::Point to_sheet(const topology::Point& p) const
    {
        const topology::Vector v{p.x, p.y, p.z};
        return {origin_.x + scale_ * dot(right_, v), origin_.y - scale_ * dot(up_, v)};
    }
    double nearness(const topology::Point& p) const { return dot(toward_eye_, {p.x, p.y, p.z}); } ///< to the eye
    double px(double pixels) const { return pixels / scale_; } ///< so many pixels of the sheet, in the world's unit
    double scale() const { return scale_; }
    const topology::Vector& toward_eye() const { return toward_eye_; }
    /// A direction of the sheet, counter-clockwise from the right [rad].
    topology::Vector across(double angle) const { return std::cos(angle) * right_ + std::sin(angle) * up_; }
    /// The direction of the sheet along which v is seen [rad].
    double angle(const topology::Vector& v) const { return std::atan2(dot(up_, v), dot(right_, v)); }
    const topology::Vector& right() const { return right_; }
    const topology::Vector& up() const { return up_; }

private:
    static topology::Vector vector(const ui::World3& w) { return {w.x, w.y, w.z}; }

    topology::Vector right_, up_, toward_eye_;
    ui::Point origin_;
    double scale_;
};

} // namespace euler
