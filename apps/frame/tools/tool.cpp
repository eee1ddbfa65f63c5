#include "apps/frame/tools/tool.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "femoop/geometry/member_geometry.h"
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

double round_section(double x, double length, const Aim& at)
{
    constexpr double parts = 20.0, reach = 6.0; // [px]
    const double nearest = std::round(x / length * parts) * length / parts;
    return !at.is_exact && std::abs(x - nearest) <= reach * at.pixel ? nearest : x;
}

std::optional<Cut> section_under(const femoop::Model& model, femoop::MemberId member, const Aim& to)
{
    if (member.index >= model.members.size()) return std::nullopt;
    const auto [start, end] = femoop::ends_of(model, model[member]);
    const std::optional<double> share = to.projection.nearest_share(start, end, to.on_sheet);
    if (!share) return std::nullopt;
    const double length = (end - start).norm();
    return Cut{member, round_section(std::clamp(*share, 0.0, 1.0) * length, length, to)};
}

} // namespace frame
