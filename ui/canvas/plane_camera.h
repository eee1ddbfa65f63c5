#pragma once

#include "ui/paint/geometry.h"

#include <span>

namespace ui {

/// A place in the model's plane, in the model's unit of length: x right, y UP.
struct World2 {
    double x = 0.0;
    double y = 0.0;

    friend bool operator==(const World2&, const World2&) = default;
};

/// Blank borders around a fitted model, in logical pixels.
struct Margins {
    double left = 40.0;
    double top = 40.0;
    double right = 40.0;
    double bottom = 40.0;
};

/// Takes places of the model's plane to the sheet and back, at one scale for both axes.
///
///     sheet.x = origin.x + scale * world.x        scale in logical pixels per unit of length
///     sheet.y = origin.y - scale * world.y        y is up in the world, down on the sheet
class PlaneCamera {
public:
    static constexpr double smallest_scale = 1e-100;
    static constexpr double largest_scale = 1e100;

    PlaneCamera() = default;
    /// The scale is taken to the nearer end of its range.
    PlaneCamera(Point origin, double scale);

    /// Where the world's origin lies on the sheet.
    Point origin() const { return origin_; }
    double scale() const { return scale_; }

    Point to_sheet(World2 p) const { return {origin_.x + scale_ * p.x, origin_.y - scale_ * p.y}; }
    World2 to_world(Point p) const { return {(p.x - origin_.x) / scale_, (origin_.y - p.y) / scale_}; }

    /// Moves the picture along with the hand.
    void pan(Point shift);
    /// Enlarges by the factor; what lies under the cursor stays under it. A factor that is not positive and finite does
    /// nothing.
    void zoom(Point cursor, double factor);
    /// Shows all the points as large as the sheet allows, in the middle of what the margins leave. Points that all lie
    /// at one place are shown at the scale that was; places that are not finite do not count; no points, no change.
    void fit(std::span<const World2> points, Size sheet, const Margins& margins = {});

    friend bool operator==(const PlaneCamera&, const PlaneCamera&) = default;

private:
    Point origin_{};
    double scale_ = 100.0;
};

} // namespace ui
