#pragma once

#include <array>
#include <vector>

#include "topology/meshing/mapped_mesher.h"
#include "topology/meshing/mesh_domain.h"

namespace topology {

/// Three chains of nodes around a region, counter-clockwise, each with both its ends, all with as many.
///
///            +
///           / \       side 0 from the first corner to the second, side 1 to the third, side 2 back
///       2  /   \  1
///         v     ^
///        /       \ .
///       +---->----+
///            0
using TrilateralSides = std::array<std::vector<CellNode>, 3>;

/// The nodes of a transfinite mesh: rows from side 0 to the third corner, each with one node less than the row below it,
/// from side 2 to side 1. Inside, a place is the mean of three blends of two sides each, less that of the corners.
///
/// Source  [BarnhillBirkhoffGordon1973]; discrete, as in [HaberShephard1981, trilinear mapping]
/// \pre sides have equally many nodes, ends are shared  \param nodes  of the sides; new ones are added
std::vector<std::vector<CellNode>> trilateral_nodes(const TrilateralSides& sides, std::vector<FlatPoint>& nodes);

/// n * n triangles for n parts of a side, row by row.
std::vector<Cell> trilateral_triangles(const std::vector<std::vector<CellNode>>& rows);

/// Three regions of four sides, one at each corner: the middles of the sides are joined to a new node, the mean of the
/// three, by straight lines of half as many parts.
/// \pre each side has an even number of parts  \param nodes  of the sides; new ones are added
std::array<MappedSides, 3> trilateral_parts(const TrilateralSides& sides, std::vector<FlatPoint>& nodes);

} // namespace topology
