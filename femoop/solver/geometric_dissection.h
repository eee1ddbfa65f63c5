#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "femoop/solver/block_graph.h"

namespace femoop {

/// An order of elimination by nested dissection in space.
struct Dissection {
    /// Blocks that follow one another in the order: a separator, or a piece that no cut parts any more.
    struct Part {
        std::size_t first = 0;  ///< in the order
        std::size_t end = 0;    ///< the first of the next part
        std::int32_t level = 0; ///< cuts that it lies in the half of: 0 for the separator that parts the whole
        bool is_separator = false;
    };
    std::vector<std::int32_t> order; ///< blocks in the order of elimination
    std::vector<Part> parts;         ///< in that order: halves before the separator between them
    std::size_t first_cut = 0;       ///< blocks in the separator that parts the whole
};

/// Cuts the blocks in two by a plane, orders each half the same way, and last the blocks along the cut.
///
///      o o o o o o x      A structure is a graph in space, so planes are good cuts and cost next to nothing to find.
///      o o o o o x o      Each cut is the best of several directions, the slanted ones among them: in a grid of bays
///      o o o o x o o      and storeys a slanted line of k nodes reaches across k bays and k storeys, so that pieces
///      o o o x o o o      are lozenges, and a lozenge has twice the nodes of a square with the same perimeter.
///      o o x o o o o
///      o x o o o o o      x  the separator: eliminated last
///
/// Source  [George1973]
/// \pre a position for every block
Dissection geometric_dissection(const BlockAdjacency& adjacency, std::span<const Eigen::Vector3d> positions);

} // namespace femoop
