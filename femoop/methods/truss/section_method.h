#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "femoop/methods/truss/truss.h"

namespace femoop::truss {

/// What a force or a bar that is known brings to an equation of a part.
struct Share {
    std::optional<std::size_t> force; ///< of Truss::forces
    std::optional<MemberId> bar;
    double size = 0.0;   ///< of the force, of a bar tension positive
    double factor = 0.0; ///< lever arm, counter-clockwise positive; where forces are added up, the cosine
};

/// One equation of equilibrium of a part, with the force of one bar alone unknown: moments about the point in which all
/// other bars meet (the Ritter point), or, where these are parallel, forces across them.
struct CutEquation {
    MemberId bar;
    std::optional<Eigen::Vector2d> ritter_point;
    Eigen::Vector2d across = Eigen::Vector2d::Zero(); ///< unit; where there is no Ritter point
    double factor = 0.0;                              ///< of the bar's force: lever arm, or cosine
    std::vector<Share> shares;
    double force = 0.0; ///< tension positive
};

/// A cut through bars that parts the truss in two.
struct RitterCut {
    std::vector<MemberId> bars;
    std::vector<MemberId> known; ///< bars that it goes through as well, whose forces are known
    std::vector<NodeId> part;    ///< whose equilibrium is written: the one with fewer forces, of two alike the left
    std::vector<CutEquation> equations; ///< of the bars that can be found, in the order of `bars`
};

/// Forces of bars that are known already.
using KnownForces = std::vector<std::optional<double>>;

std::optional<Refusal> why_no_cut(const Truss& truss, const std::vector<MemberId>& bars);

/// By Ritter. \pre why_no_cut says nothing
/// Source  [TimoshenkoYoung1965, ch. 2]
/// Lesson  courseware/04-a-truss-by-three-methods.md
RitterCut ritter_cut(const Truss& truss, const std::vector<MemberId>& bars);

/// A section that finds a bar where no joint has fewer than three unknown bars: of all such one that goes through the
/// fewest known bars, of alike ones rather not around a single joint, then one whose bar lets its joints be solved, then
/// that whose equation has the fewest terms; nothing in a complex truss.
std::optional<RitterCut> cut_through_unknown(const Truss& truss, const KnownForces& known);

} // namespace femoop::truss
