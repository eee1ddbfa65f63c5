#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "femoop/solver/block_graph.h"

namespace femoop {

/// An order of elimination by nested dissection in space.
struct Dissection {
    std::vector<std::int32_t> order; ///< blocks in the order of elimination
    std::size_t first_cut = 0;       ///< blocks in the separator that parts the whole
};

/// Cuts the blocks in two by a plane, orders each half the same way, and last the blocks along the cut.
///
///        o o o o \ o o o      A structure is a graph in space, so planes are good cuts and cost next to nothing to
///        find. o o o \ o o o o      Each cut is the best of several directions, the slanted ones among them: in a grid
///        of bays o o \ o o o o o      and storeys a slanted line of k nodes reaches across k bays and k storeys, so
///        that pieces o \ o o o o o o      are lozenges, and a lozenge has twice the nodes of a square with the same
///        perimeter.
///
/// Source  [George1973]
/// \pre a position for every block
Dissection geometric_dissection(const BlockAdjacency& adjacency, std::span<const Eigen::Vector3d> positions);

} // namespace femoop
