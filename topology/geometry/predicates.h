#pragma once

#include "topology/geometry/flat_point.h"

namespace topology {

/// On which side of the line from a to b the place c lies: positive to the left, negative to the right, 0 on it. The
/// sign is that of exact arithmetic on the given doubles, however near to 0; the value is near twice the area.
///
/// Source [Shewchuk1997, ch. 4]: a filter whose bound covers every rounding, then expansions
double orientation(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c);

/// Whether d lies within the circle through a, b, c, which run counter-clockwise: positive inside, negative outside, 0
/// on it, as exact arithmetic has it.
double in_circle(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c, const FlatPoint& d);

/// The centre of the circle through three places. \pre they are not in line
FlatPoint circumcentre(const FlatPoint& a, const FlatPoint& b, const FlatPoint& c);

} // namespace topology
