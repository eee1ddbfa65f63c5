#pragma once

#include <cstdint>
#include <vector>

#include "femoop/solver/index.h"
#include "femoop/solver/multifrontal/front_tree.h"
#include "femoop/solver/multifrontal/numbers.h"

namespace femoop {

/// L and D of K = L D L', front by front.
struct FrontFactor {
    Numbers entries; ///< [tree.n_entries()] columns of L, D on their diagonal
    /// Empty where pivots stay as the tree has them (Signs::Positive); else one number for each row of every front.
    std::vector<std::int32_t> order; ///< of pivots: the row of the front that it comes from
    std::vector<double> coupling;    ///< of pivots: D between it and the next one, 0 where it stands alone

    bool exchanges() const { return !order.empty(); }
    /// The equation of pivot i of a front.
    std::int32_t equation(const FrontTree& tree, const FrontTree::Front& front, std::int32_t i) const
    {
        return tree.rows(front)[at(exchanges() ? order[front.first_row + at(i)] : i)];
    }
    /// D between pivot i and the next one.
    double coupled(const FrontTree::Front& front, std::int32_t i) const
    {
        return exchanges() ? coupling[front.first_row + at(i)] : 0.0;
    }
};

} // namespace femoop
