#pragma once

#include "ui/paint/geometry.h"

#include <span>
#include <vector>

namespace ui {

/// The polyline with fewer points: its ends and its corners stay, and no point given lies farther than `tolerance` from
/// the line through those that are kept. A straight diagram of forty stations becomes two points.
///
/// From each kept point the cone of directions that pass every later point within the tolerance is narrowed, until a
/// point falls outside it or the line turns back; the point before is kept. Time grows with the number of points.
std::vector<Point> simplified(std::span<const Point> line, double tolerance);

} // namespace ui
