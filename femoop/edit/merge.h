#pragma once

#include <cstdint>
#include <optional>

#include "femoop/model/model.h"

namespace femoop {

/// Why two members cannot become one.
enum class MergeObstacle : std::uint8_t {
    NotTwoMembers,     ///< none, one, or more than two members meet at the node
    NotInLine,         ///< they do not go on straight
    DifferentMembers,  ///< other material, section, theory, foundation or kind; or bars, which turn at the node
    NotRigidJoint,     ///< a hinge, release, spring or offset at the node
    Held,              ///< a support, a settlement or a mass at the node
    DifferentHeating,  ///< other temperatures on the two
    LoadedInsideJoint, ///< end loads of the members at the node
};

/// Nothing where `merge_members_at` can take the node out.
std::optional<MergeObstacle> why_not_merge_at(const Model& model, NodeId node);

/// Takes out a node at which two equal members go on straight, and makes one member of them; the inverse of
/// `split_member`. Loads keep their place: those of the node become point loads, distributed loads that continue each
/// other become one, misfits add up. The member keeps the direction of the earlier one. Checks (`expected`) follow the
/// place on the member that they read; those of the node and extremes of a part are dropped, and so are those of a
/// member that had to be turned round.
/// \throws std::invalid_argument where `why_not_merge_at` gives a reason, the model as it was
MemberId merge_members_at(Model& model, NodeId node);

} // namespace femoop
