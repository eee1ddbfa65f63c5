#pragma once

#include <Eigen/Geometry>
#include <span>

#include "femoop/edit/erase.h"
#include "femoop/model/model.h"

namespace femoop {

/// Where a place goes: moved, turned, mirrored or scaled.
using Placement = Eigen::Affine3d;

Placement moved_by(const Eigen::Vector3d& shift);
/// [rad], counter-clockwise as seen against the axis, a unit vector.
Placement turned(const Eigen::Vector3d& about, double angle, const Eigen::Vector3d& axis = Eigen::Vector3d::UnitZ());
/// About a line in the xy plane. \pre the two points differ
Placement mirrored(const Eigen::Vector3d& on_line, const Eigen::Vector3d& and_on_line);
/// At the plane through a place that is square to the normal, a unit vector.
Placement mirrored_at(const Eigen::Vector3d& place, const Eigen::Vector3d& normal);
Placement scaled(const Eigen::Vector3d& about, double factor); ///< \pre factor > 0

/// Moves nodes of a structure, and what goes with them:
///   - a support turns with the structure where all members of its node do; in grillages and in space, where it can
///     hold along the global axes alone, where each of these comes to lie on another, and stays as it is elsewhere;
///   - where both ends of a member move alike, its offsets turn along, and in space its y' too; a mirrored one keeps
///     its loads' side, so local components across it change sign;
///   - a load at a length along a member stays at its share of a member that a scaling made longer, else at its
///     length, or at the member's end where it no longer fits.
/// Loads in global axes keep their direction. A coordinate that does not change keeps its text.
void place_nodes(Model& model, std::span<const NodeId> nodes, const Placement& placement);

/// Copies nodes and members with their supports and loads, each node placed anew (femoop/edit/weld.h makes one of what
/// lands at one place). The nodes of a copied member are copied too. \returns the new nodes and members
Parts copy_parts(Model& model, const Parts& parts, const Placement& placement);

} // namespace femoop
