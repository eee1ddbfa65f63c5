#pragma once

#include <Eigen/Core>
#include <array>

#include "femoop/geometry/member_geometry.h"
#include "femoop/load/place_along.h"

namespace femoop {

/// The straight line on which a member's loads are placed: its flexible part, between the rigid offsets.
struct MemberLine {
    Eigen::Vector3d start, direction; ///< direction: unit vector, zero for a member without length
    double length = 0.0;

    Eigen::Vector3d at(double x) const { return start + x * direction; }
};

MemberLine line_of(const Model& model, const Member& member);

/// The extent of the structure times this: two places nearer than that are one. Of a structure without extent it is 1.
inline constexpr double relative_nearness = 1e-6;
double nearness_of(const Model& model);

/// The coordinates of a place as numbers of a node, without what rounding left (short_number.h) of a calculation with
/// lengths up to `extent`.
std::array<Quantity, 3> coordinates(const Eigen::Vector3d& place, double extent);

} // namespace femoop
