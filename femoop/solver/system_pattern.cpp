#include "femoop/solver/system_pattern.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "femoop/solver/elimination_plan.h"
#include "femoop/solver/index.h"

namespace femoop {

SystemPattern::SystemPattern(const BlockGraph& graph)
    : block_sizes_(graph.block_sizes), clique_start_(graph.clique_start), clique_blocks_(graph.clique_blocks)
{}

SystemPattern::SystemPattern(const BlockGraph& graph, SolverKind wanted) : SystemPattern(graph)
{
    const BlockAdjacency adjacency(graph);
    EliminationPlan plan = plan_elimination(wanted, graph, adjacency);
    solver_ = plan.solver;
    order_ = std::move(plan.order);
    fill(adjacency);
}

SystemPattern::SystemPattern(const BlockGraph& graph, Ordering ordering) : SystemPattern(graph)
{
    const BlockAdjacency adjacency(graph);
    order_ = elimination_order(adjacency, ordering, graph.positions);
    fill(adjacency);
}

void SystemPattern::fill(const BlockAdjacency& adjacency)
{
    number();
    fill_columns(adjacency);
    place_cliques();
}

void SystemPattern::number()
{
    first_equation_.resize(block_sizes_.size());
    std::int32_t equation = 0;
    for (const std::int32_t block : order_) {
        first_equation_[at(block)] = equation;
        equation += block_sizes_[at(block)];
    }
    column_start_.reserve(at(equation) + 1);
}

void SystemPattern::fill_columns(const BlockAdjacency& adjacency)
{
    std::size_t n_rows = 0;
    for (std::size_t block = 0; block < block_sizes_.size(); ++block) {
        std::size_t height = at(block_sizes_[block] + 1); // twice the mean height of its own triangle
        for (const std::int32_t other : adjacency.of(static_cast<std::int32_t>(block)))
            if (first_equation_[at(other)] > first_equation_[block]) height += 2 * at(block_sizes_[at(other)]);
        n_rows += height * at(block_sizes_[block]) / 2;
    }
    rows_.reserve(n_rows);
    column_start_.push_back(0);
    std::vector<std::int32_t> lower; // first equations of the blocks below
    std::vector<std::int32_t> tail;  // the rows in which every column of the block ends
    for (const std::int32_t block : order_) {
        const std::int32_t first = first_equation_[at(block)];
        const std::int32_t end = first + block_sizes_[at(block)];
        lower.clear();
        for (const std::int32_t other : adjacency.of(block))
            if (first_equation_[at(other)] > first) lower.push_back(other);
        std::sort(lower.begin(), lower.end(),
                  [&](std::int32_t a, std::int32_t b) { return first_equation_[at(a)] < first_equation_[at(b)]; });
        tail.clear();
        for (const std::int32_t other : lower)
            for (std::int32_t i = 0; i < block_sizes_[at(other)]; ++i) tail.push_back(first_equation_[at(other)] + i);
        for (std::int32_t column = first; column < end; ++column) {
            for (std::int32_t row = column; row < end; ++row) rows_.push_back(row);
            rows_.insert(rows_.end(), tail.begin(), tail.end());
            column_start_.push_back(static_cast<std::int32_t>(rows_.size()));
        }
    }
}

/// From the end of the columns of block `upper` to the first row of block `lower`; 0 for a block without unknowns.
std::int32_t SystemPattern::distance_from_end(std::int32_t lower, std::int32_t upper) const
{
    if (block_sizes_[at(lower)] == 0 || block_sizes_[at(upper)] == 0 || lower == upper) return 0;
    const std::size_t column = at(first_equation_[at(upper)]);
    const auto begin = rows_.begin() + column_start_[column];
    const auto end = rows_.begin() + column_start_[column + 1];
    return static_cast<std::int32_t>(end - std::lower_bound(begin, end, first_equation_[at(lower)]));
}

void SystemPattern::place_cliques()
{
    const std::size_t n = clique_start_.size() - 1;
    distance_.reserve(n);
    bool all_are_pairs = true;
    for (std::size_t clique = 0; clique < n; ++clique) {
        const auto blocks = clique_of(clique);
        all_are_pairs = all_are_pairs && blocks.size() == 2;
        for (std::size_t j = 1; j < blocks.size(); ++j)
            for (std::size_t i = 0; i < j; ++i) {
                const bool i_is_above = first_equation_[at(blocks[i])] < first_equation_[at(blocks[j])];
                distance_.push_back(i_is_above ? distance_from_end(blocks[j], blocks[i])
                                               : distance_from_end(blocks[i], blocks[j]));
            }
    }
    if (all_are_pairs) return;
    pair_start_.push_back(0);
    for (std::size_t clique = 0; clique < n; ++clique) {
        const auto size = static_cast<std::int32_t>(clique_of(clique).size());
        pair_start_.push_back(pair_start_.back() + size * (size - 1) / 2);
    }
}

SparseMatrix SystemPattern::matrix() const
{
    const auto n = static_cast<Eigen::Index>(n_equations());
    SparseMatrix K(n, n);
    K.resizeNonZeros(static_cast<Eigen::Index>(rows_.size()));
    std::copy(column_start_.begin(), column_start_.end(), K.outerIndexPtr());
    std::copy(rows_.begin(), rows_.end(), K.innerIndexPtr());
    std::fill_n(K.valuePtr(), rows_.size(), 0.0);
    return K;
}

SystemPattern::Rows SystemPattern::rows_of(std::size_t clique, std::span<const std::int32_t> equations) const
{
    if (equations.size() > max_element_rows)
        throw std::length_error("SystemPattern::add: an element matrix has more than 64 rows");
    const auto blocks = clique_of(clique);
    Rows rows;
    std::uint32_t member = 0; // rows come block by block: the block of the row before is tried first
    for (std::size_t i = 0; i < equations.size(); ++i) {
        if (equations[i] == none) continue;
        const auto is_in = [&](std::uint32_t m) {
            const std::int32_t offset = equations[i] - first_equation_[at(blocks[m])];
            return offset >= 0 && offset < block_sizes_[at(blocks[m])];
        };
        if (!is_in(member))
            for (member = 0; member < blocks.size() && !is_in(member);) ++member;
        if (member == blocks.size())
            throw std::invalid_argument("SystemPattern::add: an equation is in no block of the clique");
        if (rows.n_runs == 0 || rows.run[rows.n_runs - 1].member != member)
            rows.run[rows.n_runs++] = {.begin = rows.count, .end = rows.count, .member = member};
        rows.row[rows.count++] = {.equation = equations[i],
                                  .offset = equations[i] - first_equation_[at(blocks[member])],
                                  .index = static_cast<std::int32_t>(i)};
        rows.run[rows.n_runs - 1].end = rows.count;
    }
    return rows;
}

} // namespace femoop
