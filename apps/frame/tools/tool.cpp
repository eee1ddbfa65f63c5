#include "apps/frame/tools/tool.h"

#include <cmath>
#include <numbers>

#include "ui/canvas/click.h"

namespace frame {

double direction_of(const Eigen::Vector2d& arm) { return std::atan2(arm.y(), arm.x()) * 180.0 / std::numbers::pi; }

std::optional<Part> Aim::part() const
{
    if (node) return *node;
    if (cut) return cut->member;
    if (support) return support->node;
    if (dimension) return *dimension;
    if (grip) return grip->load;
    return std::nullopt;
}

bool Aim::is_dragged_from(const Aim& press) const { return distance(on_sheet, press.on_sheet) > ui::click_reach; }

} // namespace frame
