#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "femoop/solver/block_graph.h"
#include "femoop/solver/ordering.h"
#include "femoop/solver/solver_kind.h"

namespace femoop {

/// Symmetric matrices are kept as their lower triangle, compressed by columns, rows ascending.
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Where everything goes in the system matrix: symbolic once, numeric many times.
///
/// Equations are numbered in the order of elimination, those of a block one after the other; a solver then needs no
/// permutation. Since the rows of a block are contiguous and the columns of a block end with the same rows, one number
/// per pair of blocks (how far from the end of the column) places a whole element matrix.
///
///     SystemPattern pattern(graph, SolverKind::Automatic);
///     SparseMatrix K = pattern.matrix();                                  // zeros, all places there
///     for (each member) pattern.add(K, clique, equations, Ke);
class SystemPattern {
public:
    static constexpr std::int32_t none = -1; ///< equation of a prescribed displacement
    static constexpr std::size_t max_element_rows = 64;

    /// Clique i of the graph is element i of `add`. In the order that suits the solver, or in one of a kind.
    SystemPattern(const BlockGraph& graph, SolverKind wanted);
    SystemPattern(const BlockGraph& graph, Ordering ordering);

    SolverKind solver() const { return solver_; } ///< that was wanted; of Automatic the fastest

    std::size_t n_equations() const { return column_start_.size() - 1; }
    std::size_t n_blocks() const { return block_sizes_.size(); }
    std::size_t n_nonzeros() const { return static_cast<std::size_t>(column_start_.back()); } ///< of the lower triangle

    /// The first equation of a block; its others follow.
    std::int32_t first_equation(std::size_t block) const { return first_equation_[block]; }
    std::int32_t block_size(std::size_t block) const { return block_sizes_[block]; }
    const std::vector<std::int32_t>& order() const { return order_; } ///< blocks in the order of elimination

    std::span<const std::int32_t> column_start() const { return column_start_; } ///< [equations + 1]
    std::span<const std::int32_t> rows() const { return rows_; }                 ///< [nonzeros]

    /// The matrix with every place that elements fill, all zero.
    SparseMatrix matrix() const;

    /// Adds an element matrix. `equations[i]` is the equation of row and column i of `Ke`, one of those of the clique's
    /// blocks, or `none`: then the row and column are left out. \pre K has this pattern; max_element_rows or fewer.
    template <class Scalar, class Matrix>
    void add(Eigen::SparseMatrix<Scalar>& K, std::size_t clique, std::span<const std::int32_t> equations,
             const Matrix& Ke) const;

    /// Adds to one diagonal entry: a spring.
    template <class Scalar>
    void add_to_diagonal(Eigen::SparseMatrix<Scalar>& K, std::int32_t equation, double value) const
    {
        K.valuePtr()[column_start_[static_cast<std::size_t>(equation)]] += value;
    }

private:
    /// A row of an element matrix that is not left out.
    struct Row {
        std::int32_t equation;
        std::int32_t offset; ///< from the first equation of its block
        std::int32_t index;  ///< in the element matrix
    };
    /// Rows of one block that follow one another.
    struct Run {
        std::size_t begin, end;
        std::uint32_t member; ///< the block's place in the clique
    };
    struct Rows {
        std::size_t count = 0, n_runs = 0;
        std::array<Row, max_element_rows> row;
        std::array<Run, max_element_rows> run;
        std::span<const Run> runs() const { return std::span(run).first(n_runs); }
        std::span<const Row> of(const Run& of) const { return std::span(row).subspan(of.begin, of.end - of.begin); }
    };
    Rows rows_of(std::size_t clique, std::span<const std::int32_t> equations) const;
    /// Of two runs of one block, or of one run twice.
    template <class Scalar, class Matrix>
    void add_within_block(std::span<const Row> columns, std::span<const Row> rows, const Matrix& Ke,
                          Scalar* values) const;

    /// Of the pair of a clique's blocks i and j, in either order: pairs 01, 02 12, 03 13 23, ...
    static constexpr std::size_t pair_index(std::size_t i, std::size_t j)
    {
        return i < j ? j * (j - 1) / 2 + i : i * (i - 1) / 2 + j;
    }
    std::size_t pair_start(std::size_t clique) const
    {
        return pair_start_.empty() ? clique : static_cast<std::size_t>(pair_start_[clique]);
    }
    std::span<const std::int32_t> clique_of(std::size_t clique) const
    {
        const auto start = static_cast<std::size_t>(clique_start_[clique]);
        const auto end = static_cast<std::size_t>(clique_start_[clique + 1]);
        return std::span(clique_blocks_).subspan(start, end - start);
    }
    explicit SystemPattern(const BlockGraph& graph);
    void fill(const BlockAdjacency& adjacency);
    void number();
    void start_columns(const BlockAdjacency& adjacency);
    void fill_columns(const BlockAdjacency& adjacency);
    void start_pairs();
    void place_cliques();
    std::int32_t distance_from_end(std::int32_t lower, std::int32_t upper) const;

    SolverKind solver_ = SolverKind::Automatic;
    std::vector<std::int32_t> order_;
    std::vector<std::int32_t> block_sizes_;
    std::vector<std::int32_t> first_equation_;
    std::vector<std::int32_t> column_start_; ///< [equations + 1]
    std::vector<std::int32_t> rows_;         ///< [nonzeros]
    std::vector<std::int32_t> clique_start_; ///< of each clique in clique_blocks_
    std::vector<std::int32_t> clique_blocks_;
    std::vector<std::int32_t> pair_start_; ///< of each clique in distance_; empty when every clique is a pair
    std::vector<std::int32_t> distance_;   ///< of each pair: from the end of the column to the block's first row
};

template <class Scalar, class Matrix>
void SystemPattern::add(Eigen::SparseMatrix<Scalar>& K, std::size_t clique, std::span<const std::int32_t> equations,
                        const Matrix& Ke) const
{
    const std::span<const std::int32_t> pairs = std::span(distance_).subspan(pair_start(clique));
    const Rows rows = rows_of(clique, equations);
    Scalar* const values = K.valuePtr();
    for (const Run& columns : rows.runs())
        for (const Run& below : rows.runs()) {
            if (columns.member == below.member) {
                add_within_block(rows.of(columns), rows.of(below), Ke, values);
                continue;
            }
            if (rows.row[below.begin].equation < rows.row[columns.begin].equation) continue;
            const std::int32_t distance = pairs[pair_index(below.member, columns.member)];
            for (const Row& column : rows.of(columns)) {
                Scalar* const block = values + column_start_[static_cast<std::size_t>(column.equation) + 1] - distance;
                for (const Row& row : rows.of(below)) block[row.offset] += Ke(row.index, column.index);
            }
        }
}

template <class Scalar, class Matrix>
void SystemPattern::add_within_block(std::span<const Row> columns, std::span<const Row> rows, const Matrix& Ke,
                                     Scalar* values) const
{
    for (const Row& column : columns) {
        Scalar* const diagonal = values + column_start_[static_cast<std::size_t>(column.equation)];
        for (const Row& row : rows)
            if (row.equation >= column.equation)
                diagonal[row.equation - column.equation] += Ke(row.index, column.index);
    }
}

} // namespace femoop
