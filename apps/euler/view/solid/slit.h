#pragma once

#include "topology/geometry/vector.h"
#include "ui/paint/geometry.h"

#include <functional>
#include <vector>

namespace euler {

/// The outlines of a flat region as one polygon without holes: each ring is joined to what encloses it by a slit.
///
///      o-------------o
///      |    o---o    |     From the nearest two corners that see each other, there along one side of the slit and back
///      |    |   |    |     along the other. The slit has a width, however small, so that whoever fills the polygon
///      |    o---o    |     does not take its sides for one line.
///      |   //        |
///      o--//---------o
///
/// \pre not empty; the first rim is the outer one, counter-clockwise as `flat` puts it, the others run clockwise
std::vector<topology::Point> joined_by_slits(const std::vector<std::vector<topology::Point>>& rims,
                                             const std::function<ui::Point(const topology::Point&)>& flat,
                                             double width);

} // namespace euler
