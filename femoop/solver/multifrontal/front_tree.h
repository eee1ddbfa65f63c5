#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "femoop/solver/multifrontal/column_blocks.h"

namespace femoop {

/// What a multifrontal factorization does, before any number is known.
///
///     K                            fronts                          Elimination makes neighbours of all neighbours of
///     x x . x                      {0 1 | 3}     {2 | 3}           an unknown. A front is a dense matrix for unknowns
///     x x . x                             \       /                that are eliminated together and those that they
///     . . x x      ->                      {3 |}                   touch; what is left of it afterwards, its update
///     x x x x                                                      matrix, is handed to its parent in the tree.
///
/// Unknowns whose columns are alike are eliminated together, and so are a child's with its parent's where few zeros
/// have to be stored for it.
///
/// Source  [DuffReid1983], [Liu1990], [Liu1992]
class FrontTree {
public:
    static constexpr std::int32_t none = -1;

    struct Front {
        std::int32_t n_pivots = 0;       ///< unknowns that are eliminated here
        std::int32_t n_rows = 0;         ///< these, and those that they touch
        std::int32_t parent = none;      ///< comes later
        std::int32_t first_child = none; ///< all of them lie before the parent, in postorder
        std::int32_t next_sibling = none;
        std::size_t first_row = 0;   ///< of its rows, in `rows`
        std::size_t first_entry = 0; ///< of its columns of L, which are n_rows high
        std::int32_t n_updated() const { return n_rows - n_pivots; }
    };

    FrontTree() = default;
    explicit FrontTree(const LowerPattern& pattern);

    const std::vector<Front>& fronts() const { return fronts_; } ///< in postorder
    /// The equations of a front: those that it eliminates, then the others, in the order in which all are eliminated.
    std::span<const std::int32_t> rows(const Front& front) const
    {
        return std::span(rows_).subspan(front.first_row, at(front.n_rows));
    }
    /// Of what a front leaves to its parent, where it stands among the parent's rows; ascending.
    std::span<const std::int32_t> places_in_parent(const Front& front) const
    {
        return std::span(places_).subspan(front.first_row + at(front.n_pivots), at(front.n_updated()));
    }
    std::size_t n_rows() const { return rows_.size(); } ///< of all fronts
    std::size_t n_equations() const { return n_equations_; }
    std::size_t n_entries() const { return n_entries_; }  ///< of L, with the upper corners of dense columns
    double n_operations() const { return n_operations_; } ///< multiplications with additions

private:
    class Builder;
    void find_places();

    std::vector<Front> fronts_;
    std::vector<std::int32_t> rows_;
    std::vector<std::int32_t> places_; ///< of each row in the parent
    std::size_t n_equations_ = 0;
    std::size_t n_entries_ = 0;
    double n_operations_ = 0.0;
};

/// Multiplications with additions to eliminate p of the rows of a dense symmetric matrix.
double elimination_work(std::int32_t n_pivots, std::int32_t n_rows);

} // namespace femoop
