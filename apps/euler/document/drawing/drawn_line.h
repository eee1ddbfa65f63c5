#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "apps/euler/document/stepper.h"
#include "topology/geometry/point.h"

namespace euler {

/// One operator that a drawn line takes, and the sentence that says why it is this one.
struct DrawnStep {
    std::string line;
    ui::Message why;
};

/// The operators that draw a straight line into a planar figure.
///
///   an end in the middle of an edge, or a crossing      SEMV
///   both ends free                                      MVR first (MVFS where there is nothing yet), then MEV
///   one end free                                        MEV
///   both ends on one loop of the face between them      MEF, and RINGMV of each ring that lies in the new face
///   the ends on two loops                               MEKR
///
/// What is drawn over existing vertices and edges is cut there, and what lies on an edge is there already. Where the
/// outline that leads the loops of the face around comes to lie inside the new face, MEKR and KEMR first pass its rank
/// to another one.
/// Assumes  the edges are straight and cross nowhere, as after nothing but drawn lines
/// Accuracy an end or a vertex lies on a line up to 1e-9 of the figure's extent; snap before
/// `solid` is the place of the figure among the runner's solids; none draws the first line of a new one.
/// \returns why it cannot be drawn: too short, on edges that are there, a figure in no plane, an end beside the plane
std::variant<std::vector<DrawnStep>, ui::Message> drawn_line(const Stepper& lesson, std::optional<std::size_t> solid,
                                                             const topology::Point& from, const topology::Point& to);

} // namespace euler
