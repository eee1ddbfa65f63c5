#pragma once

#include "ui/paint/geometry.h"

#include <array>
#include <span>
#include <vector>

namespace ui {

/// Two level sides and what is between them; one of the sides may be a point.
struct Trapezoid {
    std::array<Point, 2> top;    ///< left, right; y down, so that of the lesser y
    std::array<Point, 2> bottom; ///< left, right
};

/// What lies inside an odd number of loops, as trapezoids that meet along level lines alone: loops in loops are holes,
/// whichever way they run, and loops may touch.
///
///        /\             A level line sweeps from corner to corner. The edges that it crosses lie on it in pairs; where a
///       /--\----+       pair ends, or another takes its place, a trapezoid is closed.
///      /  / \   |
///     /--+---+--+       Speed  for n corners, of which the level line crosses w edges at most, n log n + n w
std::vector<Trapezoid> trapezoids(std::span<const std::vector<Point>> loops);

} // namespace ui
