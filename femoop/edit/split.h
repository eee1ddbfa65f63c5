#pragma once

#include "femoop/model/model.h"

namespace femoop {

/// The two parts of a member that was cut.
struct SplitMember {
    NodeId node; ///< between the parts
    MemberId first, second;
};

/// Cuts a member in two at a distance `x` from its first end, and joins the parts rigidly at a new node. The parts
/// together are and carry what the whole was, so no result of the structure changes:
///
///      A o===========o B       A o====o======o B
///        |--- x -->|      ->          C
///
/// Releases, springs and offsets stay at the outer ends. Loads: a distributed load is cut where it passes the node, a
/// temperature acts on both parts, a misfit is shared by length, end loads stay at their ends, a point load at the
/// very place goes to the node. A bar under `x` becomes two beams that are hinged at the outer ends, as two bars in
/// line would be a mechanism (unless the model is a truss, or the section lacks what a beam needs). The first part
/// keeps the member's place in the list; the parts are named anew only where the member had the names of its nodes.
/// Checks (`expected`) follow the place that they read; extremes of the whole member are dropped.
///
/// \pre    0 < x < length of the flexible part
/// \throws std::invalid_argument, with the model as it was
SplitMember split_member(Model& model, MemberId member, double x);

/// The same at a node that is there already. \pre the node lies at `x` and is no end of the member
SplitMember split_member(Model& model, MemberId member, double x, NodeId node);

} // namespace femoop
