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
    if (!to.may_drag() || member.index >= model.members.size()) return std::nullopt;
    const femoop::MemberGeometry geometry = femoop::geometry_of(model, model[member]);
    const Eigen::Vector3d pointer(to.pointer.x(), to.pointer.y(), 0.0);
    const double x = std::clamp((pointer - geometry.start).dot(geometry.axes.row(0).transpose()), 0.0, geometry.length);
    return Cut{member, round_section(x, geometry.length, to)};
}

} // namespace frame
