#pragma once

#include "apps/plane/document/document.h"
#include "apps/plane/document/part.h"

namespace plane {

/// Where a point is.
FlatPoint place_of(const PlaneModel& model, NodeId point);

/// Without what rounding left of a calculation (femoop/edit/short_number.h).
FlatPoint short_place(const FlatPoint& place);

/// Moves a point. Points that lie within straight sides that end at it stay at their share of them. An arc about a centre stays one: where an end moves, the other end takes the new radius; a centre
/// that moves keeps as far from one end as from the other.
void move_point(Document& document, NodeId point, const FlatPoint& to);

} // namespace plane
