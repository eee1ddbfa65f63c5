#pragma once

#include "apps/euler/view/solid/placed_solid.h"

namespace euler {

/// A solid drawn in the plane.
struct DrawnInPlane {
    const topology::Solid& solid;
    const PlacedSolid::Layout& layout;
};

/// The solid between two drawings while a step is on its way: `home` is its own, `away` that of the same solid as it is
/// at the other end of the step; `share` is 1 at home and 0 where everything stands as in `away`.
///
/// Vertices of both go straight from place to place, the whole drawing being turned by the angle by which it is turned
/// in the mean. A vertex that is not in `away` comes out of the vertex that its new edge hangs on, or out of the middle
/// of the edge that it divides. Where the drawings have different faces around them nothing is between: it is at home.
PlacedSolid::Layout layout_on_its_way(const DrawnInPlane& home, const DrawnInPlane& away, double share);

} // namespace euler
