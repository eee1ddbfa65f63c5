#include "femoop/edit/member_line.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "femoop/edit/short_number.h"

namespace femoop {

MemberLine line_of(const Model& model, const Member& member)
{
    const auto [start, end] = ends_of(model, member);
    const Eigen::Vector3d chord = end - start;
    return {start, chord.stableNormalized(), chord.stableNorm()};
}

double nearness_of(const Model& model)
{
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) box.extend(position_of(model, NodeId(i)));
    const double extent = box.isEmpty() ? 0.0 : box.diagonal().stableNorm();
    return relative_nearness * (extent > 0.0 ? extent : 1.0);
}

std::array<Quantity, 3> coordinates(const Eigen::Vector3d& place, double extent)
{
    const double scale = std::max(extent, place.cwiseAbs().maxCoeff());
    const auto coordinate = [&](int i) { return short_number(place[i], scale) + 0.0; }; // no file has a -0
    return {coordinate(0), coordinate(1), coordinate(2)};
}

} // namespace femoop
