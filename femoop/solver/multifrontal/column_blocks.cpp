#include "femoop/solver/multifrontal/column_blocks.h"

#include <algorithm>

#include "femoop/solver/elimination_tree.h"
#include "femoop/solver/index.h"

namespace femoop {

ColumnBlocks::ColumnBlocks(const LowerPattern& pattern)
{
    const auto n = static_cast<std::int32_t>(pattern.n());
    const auto column = [&](std::int32_t j) {
        const std::int32_t begin = pattern.column_start[at(j)];
        return pattern.rows.subspan(at(begin), at(pattern.column_start[at(j) + 1] - begin));
    };
    std::vector<std::int32_t> block_of(at(n));
    for (std::int32_t j = 0; j < n; ++j) {
        if (j == 0 || !std::ranges::equal(column(j - 1).subspan(1), column(j))) first.push_back(j);
        block_of[at(j)] = static_cast<std::int32_t>(first.size()) - 1;
    }
    first.push_back(n);
    for (std::int32_t block = 0; block < this->n(); ++block) {
        std::int32_t last = block;
        for (const std::int32_t row : column(first[at(block)])) {
            const std::int32_t other = block_of[at(row)];
            if (other != last) lower.items.push_back(other);
            last = other;
        }
        lower.close();
    }
}

BlockElimination::BlockElimination(const ColumnBlocks& blocks)
{
    const Lists upper = transposed(blocks.lower, at(blocks.n()));
    const auto neighbours = [&](std::int32_t k, const auto& visit) { std::ranges::for_each(upper[k], visit); };
    parent = grown_tree(at(blocks.n()), neighbours);
    for (std::int32_t block = 0; block < blocks.n(); ++block) n_rows.push_back(blocks.size(block));
    visit_factor(parent, neighbours, [&](std::int32_t k, std::int32_t i) { n_rows[at(i)] += blocks.size(k); });
}

} // namespace femoop
