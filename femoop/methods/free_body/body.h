#pragma once

#include <span>
#include <vector>

#include "femoop/discretisation/discretisation.h"

namespace femoop::free_body {

/// A place where a member is cut through.
struct Cut {
    MemberId member;
    double x = 0.0; ///< from the first end of its flexible part, within its length

    friend bool operator==(const Cut&, const Cut&) = default;
};

/// A part of a member, from one place along its flexible part to another.
struct Piece {
    MemberId member;
    double from = 0.0, to = 0.0;
    bool begins_at_cut = false, ends_at_cut = false; ///< it is not joined to a node there, though it may reach it
};

/// A part of a structure that is lifted out: nodes, each with the rigid arms of the members that meet it, and pieces of
/// members. A piece is joined to the node at its end if the body has both; every other end is a cut.
///
/// Point loads at a cut belong to what lies before it along the member; those at a member's very end to its node.
struct Body {
    std::vector<NodeId> nodes;
    std::vector<Piece> pieces;

    bool is_empty() const { return nodes.empty() && pieces.empty(); }
};

/// One node, all members cut off at their ends.
Body body_of(NodeId node);

/// Whole members, and the nodes that join two of them or more.
Body body_of(const Discretisation& structure, std::span<const MemberId> members);

/// All that hangs together with any of these nodes where members are cut. Cuts that do not part the structure leave it
/// whole: then both sides of a cut are in the body.
Body body_of(const Discretisation& structure, std::span<const Cut> cuts, std::span<const NodeId> beside);

/// Where none of the cuts parts the structure: members without a cut, one after the other, that join both sides of one;
/// of all such ways the shortest. None where anything is parted.
std::vector<MemberId> members_across(const Discretisation& structure, std::span<const Cut> cuts);

} // namespace femoop::free_body
