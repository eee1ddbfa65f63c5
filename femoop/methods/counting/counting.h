#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "femoop/discretisation/statics.h"
#include "femoop/methods/counting/rings.h"
#include "femoop/model/model.h"

namespace femoop::counting {

/// What the joints at one node let go: n forces that the members would carry there if they were rigidly joined.
///
///     two members and a hinge        1        three members and a hinge       2        (one less than members)
///
/// What turns by itself holds nothing, so its release counts nothing: a node whose members are all hinged to it, a
/// member that is released about its own axis at both ends.
struct ReleasedJoint {
    struct End {
        MemberId member;
        std::size_t end = 0; ///< 0 its first, 1 its second
        int n_released = 0;  ///< of its section forces
    };
    NodeId node;
    std::vector<End> ends;
    int n_free_rotations = 0; ///< of the node, and of nodes that turn with it as one

    int count() const; ///< may be 0
};

/// How many reactions the support of a node has.
struct SupportReactions {
    NodeId node;
    int n_blocked = 0; ///< degrees of freedom
    int n_springs = 0;

    int count() const { return n_blocked + n_springs; }
};

/// The degree of static indeterminacy as the sum that one writes at the blackboard:
///
///     frame, grillage    rings x 3 (in space 6) - releases + reactions - parts x 3 (6)
///     truss              members - releases + reactions - joints x 2 (3)
///
/// Each closed ring of members could be cut once, which frees so many section forces, and be open.
/// Springs count as what they hold, settlements, offsets and members without strain change nothing.
/// Source  [Kassimali, ch. 3]
struct Counting {
    AnalysisKind kind = AnalysisKind::Frame2d;
    std::size_t n_members = 0;
    std::size_t n_joints = 0; ///< nodes with members
    std::size_t n_parts = 0;  ///< pieces that members join
    std::vector<Ring> rings;  ///< of a truss none
    std::vector<ReleasedJoint> releases;
    std::vector<SupportReactions> reactions;
    std::vector<NodeId> loose_nodes;        ///< without members, which count nothing
    bool has_foundation = false;            ///< a continuous foundation makes the true number infinite
    std::optional<std::size_t> n_motions{}; ///< ways to move without strain; absent: more than were looked for

    int forces_per_ring() const { return is_3d(kind) ? 6 : 3; }
    int equations_per_joint() const { return dofs(kind).size(); }
    int equations_per_part() const { return is_3d(kind) ? 6 : 3; } ///< of a piece as a whole
    int n_released() const;
    int n_reactions() const;

    Indeterminacy degree() const; ///< femoop/discretisation/statics.h
};

/// \throws ModelError where the model has errors; a structure that can move is counted too
Counting count(const Model& model);

} // namespace femoop::counting
