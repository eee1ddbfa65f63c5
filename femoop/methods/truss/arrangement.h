#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "femoop/methods/truss/truss.h"

namespace femoop::truss {

/// A bar or a force that meets a joint.
struct Spoke {
    std::optional<MemberId> bar;
    std::optional<std::size_t> force; ///< of Truss::forces
    Eigen::Vector2d away;             ///< unit, on which side of the joint it lies
};

/// Of every joint what meets it, clockwise.
using Arrangement = std::vector<std::vector<Spoke>>;

/// The bars at a joint, clockwise.
std::vector<MemberId> clockwise_bars(const Truss& truss, NodeId joint);

/// From one direction clockwise to another: more than 0, at most 2 pi, which is once around.
double clockwise_angle(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

/// Whether forces may lie between this bar and the next one clockwise.
using IsOpen = std::function<bool(NodeId joint, MemberId bar)>;

/// Lays each force between two bars of its joint: before the joint, which it pushes, where it is clear of bars; else
/// there or behind, where it pulls, whichever is clearer; else, as its line runs along bars or between others, in the
/// middle of the widest room.
Arrangement arrange(const Truss& truss, const IsOpen& is_open);

} // namespace femoop::truss
