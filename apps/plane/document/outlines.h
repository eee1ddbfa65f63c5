#pragma once

#include <optional>

#include "apps/plane/discretize/drawing.h"
#include "apps/plane/document/document.h"
#include "apps/plane/document/part.h"

namespace plane {

/// Two free ends of curves that lie near each other, as where an outline was not closed.
struct Gap {
    FlatPoint from, to;
    double width = 0.0;
    bool is_narrow = false;                         ///< the ends were meant to be one, by the size of the drawing
    std::optional<NodeId> point_from{}, point_to{}; ///< at the ends
};

/// The narrowest gap of a drawing: between the two free ends of a chain of several edges, however wide, or from a free
/// end to the nearest vertex of others that is within a twentieth of the drawing. Nothing where no curve ends free.
std::optional<Gap> narrowest_gap(const discretize::Drawing& drawing);

/// Joins the two ends by a straight line; of a narrow gap the point at the first end moves to the second and is one with
/// it.
void close_gap(Document& document, const Gap& gap);

/// Two points become one: what the one draws and carries is the other's. A polyline whose ends become one is closed.
void join_points(Document& document, NodeId gone, NodeId by);

} // namespace plane
