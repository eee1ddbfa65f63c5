#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "femoop/model/model.h"

namespace femoop {

/// The straight line on which a member's loads are placed: its flexible part, between the rigid offsets.
struct MemberLine {
    Eigen::Vector3d start, direction; ///< direction: unit vector, zero for a member without length
    double length = 0.0;

    Eigen::Vector3d at(double x) const { return start + x * direction; }
};

/// An offset as a vector; zero for an empty one.
Eigen::Vector3d vector_of(const std::vector<Quantity>& offset);

MemberLine line_of(const Model& model, const Member& member);

Eigen::Vector3d position_of(const Model& model, NodeId node); ///< z is 0 in a plane model

/// Where a position along a member of this length lies, from 0 to `length`.
double distance(const Position& position, double length);

/// The extent of the structure times 1e-6: two places nearer than that are one. 1e-6 for a structure without extent.
double nearness_of(const Model& model);

/// The coordinates of a place as numbers of a node.
std::array<Quantity, 3> coordinates(const Eigen::Vector3d& place);

} // namespace femoop
