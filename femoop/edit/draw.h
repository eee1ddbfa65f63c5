#pragma once

#include <Eigen/Core>
#include <vector>

#include "femoop/edit/crossing.h"

namespace femoop {

/// The node at this place: the one that is there, else a new one. Members that pass the place are cut there
/// (femoop/edit/split.h).
NodeId place_node(Model& model, const Eigen::Vector3d& place);

/// Cuts every member that passes a node without ending there, where the node or the member was moved or made.
void cut_members_at_nodes(Model& model, const MovedParts& moved);

/// Draws a straight line of members, each made like `pattern` (its name and nodes aside), from one place to another:
///
///              D                        D
///              |                        |
///      A . . . | . . . B   ->   A o-----E-----o B      the crossed member is cut too
///              |                        |
///              C                        C
///
/// The line gets a node at each end, at each node that it passes, and where it crosses a member unless crossings are
/// to be kept. Where two of these nodes are joined by a member already none is added, so a line drawn twice is one.
/// \returns the members of the line from start to end, those that were there included
/// \throws std::invalid_argument where the places are one (nearer than `nearness_of`), the model as it was
std::vector<MemberId> draw_member(Model& model, const Eigen::Vector3d& start, const Eigen::Vector3d& end,
                                  const Member& pattern, Crossings crossings = Crossings::Cut);

/// The member that joins these nodes in a straight line, either way round.
std::optional<MemberId> member_between(const Model& model, NodeId a, NodeId b);

} // namespace femoop
