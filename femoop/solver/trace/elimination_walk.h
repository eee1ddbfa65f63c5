#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "femoop/solver/block_graph.h"

namespace femoop {

/// What elimination in some order costs, counted in unknowns.
struct EliminationCounts {
    std::size_t n_unknowns = 0;
    std::size_t n_entries_of_K = 0;    ///< of its lower triangle, the diagonal among them
    std::size_t n_entries = 0;         ///< of L, the diagonal among them
    std::size_t n_profile_entries = 0; ///< of the rows from their first entry on, which is what a skyline keeps
    double n_operations = 0.0;         ///< multiplications and divisions: the sum of c (c + 3) / 2 over the columns of
                                       ///< L, where c is the number of entries below the diagonal
    double n_profile_operations = 0.0; ///< the same sum for the profile, by rows
    std::size_t largest_front = 0;     ///< rows
    std::size_t n_levels = 0;          ///< fronts from a root of the tree to the leaf that is farthest from it
    std::size_t most_waiting = 0;      ///< entries of update matrices, lower triangles, that wait at one time

    std::size_t n_fill() const { return n_entries - n_entries_of_K; } ///< zeros of K that L has an entry for
};

/// Elimination in one order, walked through front by front before any number is known.
///
///     o---o---o      Eliminating a block couples all that it is coupled with. What it was coupled with, in K or since
///     |   |   |      then, is left in its front; the update matrix, over those that are left, waits until the first of
///     x---x---o      them is eliminated, and is added up in that one's front: its parent in the elimination tree.
///
/// Blocks whose columns of L are alike from their diagonals on share a front. No zero is stored for it: the solver
/// itself merges more (femoop/solver/multifrontal/front_tree.h).
///
/// Source  [Irons1970], [DuffReid1983], [Liu1992]; operations [GeorgeLiu1981, ch. 2]
/// Lesson  courseware/02-the-front-walks.md
struct EliminationWalk {
    static constexpr std::int32_t none = -1;

    /// One step of the walk.
    struct Front {
        std::int32_t first = 0;     ///< place in the order of the first block that it eliminates
        std::int32_t end = 0;       ///< place of the first block of the next front
        std::int32_t parent = none; ///< front that takes its update matrix; none where nothing is left
        std::size_t n_pivots = 0;   ///< unknowns that are eliminated
        std::size_t n_left = 0;     ///< unknowns that are left: rows of the update matrix
        std::size_t n_waiting = 0;  ///< entries of the update matrices that wait when it is done, its own among them

        std::size_t n_rows() const { return n_pivots + n_left; }
        /// Of the columns of L that it leaves.
        std::size_t n_entries() const { return n_pivots * (n_pivots + 1) / 2 + n_pivots * n_left; }
        std::size_t n_update_entries() const { return n_left * (n_left + 1) / 2; } ///< of the lower triangle
    };

    /// A block below the diagonal in a column of L.
    struct Entry {
        std::int32_t row = 0; ///< place in the order
        bool is_fill = false; ///< K has zeros there
    };

    std::vector<std::int32_t> order;         ///< blocks with unknowns in the order of elimination
    std::vector<std::int32_t> parent;        ///< elimination tree of the places in the order; none of a root
    std::vector<Front> fronts;               ///< in that order: children come before their parents
    std::vector<std::vector<Entry>> columns; ///< of L, by place, rows ascending; empty where only counts are wanted
    EliminationCounts counts;

    /// What is left in a front once its pivots are eliminated. \pre columns are there
    std::span<const Entry> left(const Front& front) const { return columns[static_cast<std::size_t>(front.end) - 1]; }
    std::vector<std::int32_t> children_of(std::int32_t front) const;
    /// The front in which each place of the order is eliminated.
    std::vector<std::int32_t> front_of_place() const;
};

/// How much of a walk is kept: of a large system the counts alone.
enum class WalkDetail : std::uint8_t { Counts, Pattern };

/// \pre `order` has every block once; those without unknowns are passed over
EliminationWalk walk_elimination(const BlockGraph& graph, const BlockAdjacency& adjacency,
                                 std::span<const std::int32_t> order, WalkDetail detail);

} // namespace femoop
