#include "femoop/edit/member_line.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace femoop {

MemberLine line_of(const Model& model, const Member& member)
{
    const auto [start, end] = ends_of(model, member);
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

std::array<Quantity, 3> coordinates(const Eigen::Vector3d& place)
{
    const Eigen::Vector3d plain = place.array() + 0.0; // no file has a -0
    return {plain[0], plain[1], plain[2]};
}

} // namespace femoop
