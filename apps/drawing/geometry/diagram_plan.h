#pragma once

#include "ui/paint/geometry.h"
#include "ui/paint/theme.h"

#include <Eigen/Core>
#include <span>

namespace drawing {

/// Takes points of a diagram of forces, which are forces, to the sheet.
class DiagramPlan {
public:
    /// As large as the panel allows, with room for the head and the names of points. \pre there is a point
    DiagramPlan(std::span<const Eigen::Vector2d> points, const ui::Box& panel, const ui::Theme& theme);

    ui::Point operator()(const Eigen::Vector2d& force) const;
    double scale() const { return scale_; } ///< logical pixels per unit of force

private:
    Eigen::Vector2d middle_;
    ui::Point center_;
    double scale_ = 1.0;
};

} // namespace drawing
