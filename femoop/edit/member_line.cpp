#include "femoop/edit/member_line.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace femoop {

Eigen::Vector3d vector_of(const std::vector<Quantity>& offset)
{
    Eigen::Vector3d v = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < offset.size(); ++i) v[static_cast<Eigen::Index>(i)] = offset[i];
    return v;
}

Eigen::Vector3d position_of(const Model& model, NodeId node)
{
    const std::array<Quantity, 3>& at = model[node].at;
    return {at[0], at[1], is_3d(model.analysis) ? at[2].value() : 0.0};
}

MemberLine line_of(const Model& model, const Member& member)
{
    const Eigen::Vector3d start = position_of(model, member.nodes[0]) + vector_of(member.start.offset);
    const Eigen::Vector3d end = position_of(model, member.nodes[1]) + vector_of(member.end.offset);
    const Eigen::Vector3d chord = end - start;
    return {start, chord.stableNormalized(), chord.stableNorm()};
}

double distance(const Position& position, double length)
{
    const auto* const percent = std::get_if<Percent>(&position);
    const double x = percent ? percent->value / 100.0 * length : std::get<Quantity>(position).value();
    return std::clamp(x, 0.0, length);
}

double nearness_of(const Model& model)
{
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) box.extend(position_of(model, NodeId(i)));
    const double extent = box.isEmpty() ? 0.0 : box.diagonal().stableNorm();
    return 1e-6 * (extent > 0.0 ? extent : 1.0);
}

std::array<Quantity, 3> coordinates(const Eigen::Vector3d& place) { return {place[0], place[1], place[2]}; }

} // namespace femoop
