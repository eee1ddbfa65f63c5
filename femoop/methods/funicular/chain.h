#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "femoop/discretisation/discretisation.h"
#include "femoop/methods/funicular/refusal.h"

namespace femoop::funicular {

/// Members of a plane frame one after the other, from left to right: an arch, a beam.
///
///            o-----o
///        o--'       '--o  B      x grows from member to member; nodes[i] is at the left of links[i]
///    A o
struct Chain {
    struct Link {
        MemberId member;
        bool is_reversed = false; ///< its second end is its left one
    };
    std::vector<Link> links;           ///< one at least
    std::vector<NodeId> nodes;         ///< one more
    std::vector<Eigen::Vector2d> axis; ///< from node to node, along rigid arms too; x never falls
    /// Those between the ends that a support or another member holds; what these do there is no load of a funicular.
    std::vector<NodeId> held{};
    /// Where the hinge is if there is one alone between the ends.
    std::optional<Eigen::Vector2d> hinge{};
    /// Pinned at both ends, with one hinge between them, and the whole structure: statics alone gives its thrust.
    bool is_three_hinged_arch = false;

    const Eigen::Vector2d& left() const { return axis.front(); }
    const Eigen::Vector2d& right() const { return axis.back(); }
    double span() const { return right().x() - left().x(); } ///< > 0
    double height(double x) const;                           ///< of the axis
    double chord(double x) const;                            ///< height of the line from end to end
    /// The hinge, else where the axis is farthest over or under the chord; nothing where it lies on that all along.
    std::optional<Eigen::Vector2d> crown() const;
};

/// The members that may be links: all that do not stand upright.
std::vector<MemberId> members_across(const Discretisation& structure);

std::optional<Refusal> why_no_chain(const Discretisation& structure, std::span<const MemberId> members);

/// \pre why_no_chain says nothing
Chain chain_of(const Discretisation& structure, std::span<const MemberId> members);

} // namespace femoop::funicular
