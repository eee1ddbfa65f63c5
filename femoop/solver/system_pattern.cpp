#include "femoop/solver/system_pattern.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "femoop/solver/at_once.h"
#include "femoop/solver/elimination_plan.h"
#include "femoop/solver/index.h"

namespace femoop {

namespace {

constexpr std::size_t blocks_at_once = 20000; // or cliques, that a thread does

} // namespace

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
    start_columns(adjacency);
    fill_columns(adjacency);
    start_pairs();
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

/// The columns of a block have the rest of its own triangle each, and the rows of the blocks below.
void SystemPattern::start_columns(const BlockAdjacency& adjacency)
{
    std::vector<std::int32_t> n_below(block_sizes_.size(), 0);
    in_ranges(block_sizes_.size(), blocks_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t block = begin; block < end; ++block)
            for (const std::int32_t other : adjacency.of(static_cast<std::int32_t>(block)))
                if (first_equation_[at(other)] > first_equation_[block]) n_below[block] += block_sizes_[at(other)];
    });
    column_start_.push_back(0);
    for (const std::int32_t block : order_)
        for (std::int32_t height = block_sizes_[at(block)]; height > 0; --height)
            column_start_.push_back(column_start_.back() + height + n_below[at(block)]);
}

void SystemPattern::fill_columns(const BlockAdjacency& adjacency)
{
    rows_.resize(n_nonzeros());
    in_ranges(order_.size(), blocks_at_once, [&](std::size_t begin, std::size_t end) {
        std::vector<std::pair<std::int32_t, std::int32_t>> below; // first equations and sizes of the blocks
        for (std::size_t i = begin; i < end; ++i) {
            const std::int32_t block = order_[i], first = first_equation_[at(block)];
            below.clear();
            for (const std::int32_t other : adjacency.of(block))
                if (first_equation_[at(other)] > first)
                    below.emplace_back(first_equation_[at(other)], block_sizes_[at(other)]);
            std::sort(below.begin(), below.end());
            const std::int32_t last = first + block_sizes_[at(block)];
            for (std::int32_t column = first; column < last; ++column) {
                auto next = rows_.begin() + column_start_[at(column)];
                for (std::int32_t row = column; row < last; ++row) *next++ = row;
                for (const auto& [start, size] : below)
                    for (std::int32_t row = start; row < start + size; ++row) *next++ = row;
            }
        }
    });
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

void SystemPattern::start_pairs()
{
    const std::size_t n = clique_start_.size() - 1;
    bool all_are_pairs = true;
    for (std::size_t clique = 0; clique < n && all_are_pairs; ++clique) all_are_pairs = clique_of(clique).size() == 2;
    if (all_are_pairs) return;
    pair_start_.reserve(n + 1);
    pair_start_.push_back(0);
    for (std::size_t clique = 0; clique < n; ++clique) {
        const auto size = static_cast<std::int32_t>(clique_of(clique).size());
        pair_start_.push_back(pair_start_.back() + size * (size - 1) / 2);
    }
}

void SystemPattern::place_cliques()
{
    const std::size_t n = clique_start_.size() - 1;
    distance_.resize(pair_start(n));
    in_ranges(n, blocks_at_once, [&](std::size_t begin, std::size_t end) {
        for (std::size_t clique = begin; clique < end; ++clique) {
            const auto blocks = clique_of(clique);
            auto next = distance_.begin() + static_cast<std::ptrdiff_t>(pair_start(clique));
            for (std::size_t j = 1; j < blocks.size(); ++j)
                for (std::size_t i = 0; i < j; ++i) {
                    const bool i_is_above = first_equation_[at(blocks[i])] < first_equation_[at(blocks[j])];
                    *next++ = i_is_above ? distance_from_end(blocks[j], blocks[i])
                                         : distance_from_end(blocks[i], blocks[j]);
                }
        }
    });
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
