#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "femoop/solver/multifrontal/lists.h"

namespace femoop {

/// A lower triangle by columns, in an order of elimination.
struct LowerPattern {
    std::span<const std::int32_t> column_start; ///< [equations + 1]
    std::span<const std::int32_t> rows;         ///< ascending in each column, the diagonal first
    std::size_t n() const { return column_start.size() - 1; }
};

/// Unknowns whose columns are alike: those of a node as a rule. All symbolic work is done on blocks.
struct ColumnBlocks {
    std::vector<std::int32_t> first; ///< equation of each block, and the end of the last one
    Lists lower;                     ///< of each block those after it that it is coupled with

    explicit ColumnBlocks(const LowerPattern& pattern);
    std::int32_t n() const { return static_cast<std::int32_t>(first.size()) - 1; }
    std::int32_t size(std::int32_t block) const { return first[at(block) + 1] - first[at(block)]; }
};

/// The elimination tree of the blocks and how many rows each one's columns of L have.
struct BlockElimination {
    std::vector<std::int32_t> parent; ///< -1 of a root
    std::vector<std::int32_t> n_rows; ///< equations

    explicit BlockElimination(const ColumnBlocks& blocks);
};

} // namespace femoop
