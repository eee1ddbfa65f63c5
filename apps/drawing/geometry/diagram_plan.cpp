#include "apps/drawing/geometry/diagram_plan.h"

#include <algorithm>
#include <limits>

namespace drawing {

using Eigen::Vector2d;

DiagramPlan::DiagramPlan(std::span<const Vector2d> points, const ui::Box& panel, const ui::Theme& theme)
{
    Vector2d least = points.front(), most = least;
    for (const Vector2d& point : points) {
        least = least.cwiseMin(point);
        most = most.cwiseMax(point);
    }
    const double edge = 3.2 * theme.type().normal, head = 3.4 * theme.type().normal;
    const ui::Box room{{panel.min.x + edge, panel.min.y + head}, {panel.max.x - edge, panel.max.y - edge}};
    const Vector2d size = most - least;
    const double x = size.x() > 0.0 ? room.width() / size.x() : std::numeric_limits<double>::infinity();
    const double y = size.y() > 0.0 ? room.height() / size.y() : std::numeric_limits<double>::infinity();
    scale_ = std::max(std::min(x, y), 0.0);
    middle_ = 0.5 * (least + most);
    center_ = room.center();
}

ui::Point DiagramPlan::operator()(const Vector2d& force) const
{
    const Vector2d from_middle = scale_ * (force - middle_);
    return center_ + ui::Point{from_middle.x(), -from_middle.y()};
}

} // namespace drawing
