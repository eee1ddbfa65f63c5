#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace femoop {

/// The dense matrix of a front, by columns, lower triangle: the columns of L that it becomes, and what is left.
///
///      n_pivots  n_updated
///     [ pivots |         ]   `panel` [n_rows x n_pivots], n_rows high
///     [ below  | updated ]   `update` [n_updated x n_updated], n_updated high
struct DenseFront {
    double* panel;
    double* update;
    std::int32_t n_pivots;
    std::int32_t n_rows;
    /// Where pivots may be exchanged, as a matrix that is indefinite asks for; null where they stay. D then has an
    /// entry beside its diagonal where two pivots are eliminated together.
    std::int32_t* order = nullptr; ///< [n_pivots] the row that each pivot comes from
    double* coupling = nullptr;    ///< [n_pivots] D between a pivot and the next one; 0 where it stands alone
};

/// What a child leaves to its parent: a lower triangle by columns, n high.
struct ChildUpdate {
    const double* entries;
    const std::int32_t* places; ///< [n] of its rows among the parent's, ascending
    std::int32_t n;
};

/// Numbers that the elimination of a front needs beside it.
inline std::size_t workspace_size(std::int32_t n_pivots, std::int32_t n_rows)
{
    return static_cast<std::size_t>(n_pivots) * static_cast<std::size_t>(n_rows);
}

/// The columns of L of a front, as elimination leaves them.
struct FrontColumns {
    const double* panel; ///< [n_rows x n_pivots] n_rows high; what stands on the diagonal and above it is not looked at
    std::int32_t n_pivots;
    std::int32_t n_rows;
};

/// Whoever works through the tiles of a large front: work(context, tile) for all of them, in any order or at a time.
struct TileWorkers {
    void* self;
    void (*for_each)(void* self, std::int32_t n_tiles, void (*work)(void* context, std::int32_t tile), void* context);
};

/// One tile after the other, in the thread that calls.
extern const TileWorkers one_by_one;

/// Dense elimination, made for one kind of processor. The same numbers come out bit for bit whoever does the tiles.
struct DenseKernel {
    /// Eliminates the pivots: the panel becomes the columns of L, whose diagonal of ones gives its place to D, where
    /// K = L D L'; update -= below pivots^-1 below'. Returns how many pivots it eliminated: fewer than all if the next
    /// was zero or not finite; nothing from there on is worth anything.
    std::int32_t (*eliminate)(const DenseFront& front, double* workspace, const TileWorkers& workers);
    /// Adds the update matrix of a child, n x n, in those of the front's columns begin .. end - 1 that it falls into.
    void (*add_update)(const DenseFront& front, const ChildUpdate& child, std::int32_t begin, std::int32_t end);
    /// x [n_rows], a right-hand side: L y = x for the pivots, and x -= L y below them.
    void (*solve_forward)(const FrontColumns& L, double* x);
    /// x [n_rows], known below the pivots: L' x = y for these.
    void (*solve_backward)(const FrontColumns& L, double* x);
    std::string_view name; ///< "avx512", "avx2" or "baseline"
};

/// The fastest that this processor can run.
const DenseKernel& dense_kernel();

} // namespace femoop
