#pragma once

#include <optional>
#include <vector>

#include "femoop/discretisation/discretisation.h"
#include "femoop/model/model.h"

namespace femoop::influence {

/// The members that go on straight from one to either side, as a load passes them: from left to right, a column from
/// below.
///
///      o---AB---o---BC---o---CD---o      of BC: AB, BC, CD
///               |        |
///
/// Of a mesh where several go on straight from a node the first one is taken.
std::vector<MemberId> straight_path(const Model& model, MemberId member);

/// The members in the order in which a load passes each of them once, from the end that is farther to the left, or
/// lower; nothing where they are no such row.
std::optional<std::vector<MemberId>> row_of(const Model& model, const std::vector<MemberId>& members);

/// The path that is meant where none is named: the first of the model's that passes the effect's member or node, or its
/// first one; in a model without paths the straight path of the member, or the longest at the node. Where a load cannot
/// bend that path, as it points along it, and in a truss: the longest of all that it can bend.
/// \param load  the unit load, global axes  \pre the model has members, the effect its member or node
std::vector<MemberId> usual_path(const Model& model, const MovingEffect& effect, const NodeVector& load);

/// Every force that a support can bear; none of a node without one.
std::vector<MovingEffect> reactions_at(const Model& model, NodeId node);

/// A reaction along what the node's support leaves free, which is 0 whatever the loads are.
bool is_unheld_reaction(const Model& model, const MovingEffect& effect);

/// The node whose support holds a displacement itself, so that it is 0 whatever the loads are: one of the node, or of a
/// member's end that goes with it. Nothing where it can move, be it against a spring.
std::optional<NodeId> holding_support(const Model& model, const MovingEffect& effect);

} // namespace femoop::influence
