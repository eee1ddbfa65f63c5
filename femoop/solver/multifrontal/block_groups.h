#pragma once

#include <cstdint>
#include <vector>

#include "femoop/solver/multifrontal/column_blocks.h"

namespace femoop {

/// Blocks that are eliminated together, and the tree of these: such as follow one another with the same rows below, and
/// children with their parent where few zeros have to be stored for it.
///
/// Source  [AshcraftGrimes1989]
class BlockGroups {
public:
    static constexpr std::int32_t none = -1;

    BlockGroups(const ColumnBlocks& blocks, const BlockElimination& elimination);

    std::int32_t n() const { return static_cast<std::int32_t>(n_pivots_.size()); } ///< those that were merged too
    bool is_head(std::int32_t group) const { return head(group) == group; }        ///< not merged into another
    std::int32_t head_of(std::int32_t block) const { return head(group_of_[at(block)]); }
    std::int32_t parent(std::int32_t head_group) const;
    std::int32_t n_pivots(std::int32_t head_group) const { return n_pivots_[at(head_group)]; }
    std::int32_t n_rows(std::int32_t head_group) const { return n_rows_[at(head_group)]; }

private:
    std::int32_t head(std::int32_t group) const { return head_[at(group)]; }
    void gather(const ColumnBlocks& blocks, const BlockElimination& elimination);
    void merge();
    void merge(std::int32_t child, std::int32_t group);
    Lists children() const;

    std::vector<std::int32_t> group_of_; ///< of each block
    std::vector<std::int32_t> parent_;   ///< group, before any was merged
    std::vector<std::int32_t> head_;     ///< group that it was merged into, or itself
    std::vector<std::int32_t> n_pivots_; ///< equations
    std::vector<std::int32_t> n_rows_;   ///< equations
    std::vector<double> zeros_;          ///< that are stored
};

/// The heads in postorder: of siblings first those that leave least of what they need themselves.
///
/// Source  [Liu1986, theorem 3.2]
std::vector<std::int32_t> postorder(const BlockGroups& groups);

} // namespace femoop
