#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "femoop/solver/trace/elimination_walk.h"

namespace femoop {

/// How an entry of a front's matrix comes to be.
enum class FrontEntry : std::uint8_t {
    FromK,        ///< K has it, in a column that this front eliminates; children may add to it
    FromChildren, ///< an update matrix of a child brings it
    Made          ///< this front's own elimination fills it
};

/// The matrix of a front, block by block: first the blocks that it eliminates, then those that are left.
///
///     K K . .     rows that are eliminated: columns of L when it is done
///     K K . .
///     ---------
///     C K | C .   rows that are left: below and right of them the update matrix
///     K M | M M   (K from K, C from children, M made here)
struct FrontMatrix {
    std::vector<std::int32_t> places; ///< of its blocks in the order of elimination, ascending
    std::size_t n_eliminated = 0;     ///< of them
    std::vector<FrontEntry> entries;  ///< lower triangle, row by row

    FrontEntry at(std::size_t row, std::size_t column) const { return entries[row * (row + 1) / 2 + column]; }
};

/// \pre the walk has its columns; front < fronts.size()
FrontMatrix front_matrix(const EliminationWalk& walk, std::size_t front);

} // namespace femoop
