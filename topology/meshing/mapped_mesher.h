#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "topology/meshing/mesh_domain.h"

namespace topology {

/// Four chains of nodes around a region, counter-clockwise, each with both its ends: opposite ones have as many.
///
///            2 <----
///      +--------------+
///      |              |  ^
///   3  |              |  |  1
///      v              |
///      +--------------+
///           0 ---->
using MappedSides = std::array<std::vector<CellNode>, 4>;

/// How quadrilaterals are cut into triangles: by the diagonal from a cell's first to its third corner, as side 0 sees it
/// from its start, by the other one, by both, which meet in a node of their own, or by the shorter one.
enum class Diagonal : std::uint8_t { Right, Left, Cross, Shortest };

/// The nodes of a transfinite mesh: rows from side 0 to side 2, each from side 3 to side 1, so that the outer ones are
/// those of the sides. Inside, places blend opposite sides, by how far along each its nodes are.
///
/// Source  [GordonHall1973, eq. (9)]
/// \pre opposite sides have equally many nodes, ends are shared  \param nodes  of the sides; new ones are added
std::vector<std::vector<CellNode>> mapped_nodes(const MappedSides& sides, std::vector<FlatPoint>& nodes);

/// The nodes of a swept mesh: rows as above. Side 0 is carried along sides 3 and 1, moved, turned and scaled so that its
/// ends stay on them, and so is side 2, backwards; each row blends both copies by how far it is along. So a side that is
/// bent runs on through the region, which a map flattens where the way bends.
///
/// Source  [StatenCanannOwen1999] for sweeps from a source along its sides to a target; here in the plane
/// \pre as of `mapped_nodes`
std::vector<std::vector<CellNode>> swept_nodes(const MappedSides& sides, std::vector<FlatPoint>& nodes);

/// One quadrilateral between four neighbours, row by row.
std::vector<Cell> quadrilaterals(const std::vector<std::vector<CellNode>>& rows);
/// Two triangles in place of each, or four. \param nodes  those in the middle of four are added
std::vector<Cell> triangles(const std::vector<Cell>& quadrilaterals, Diagonal diagonal, std::vector<FlatPoint>& nodes);

} // namespace topology
