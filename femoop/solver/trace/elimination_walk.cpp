#include "femoop/solver/trace/elimination_walk.h"

#include <algorithm>

#include "femoop/solver/elimination_tree.h"
#include "femoop/solver/index.h"
#include "femoop/solver/trace/column_counts.h"

namespace femoop {

namespace {

constexpr std::int32_t no_block = EliminationWalk::none;

/// Operations on a column, or a row, with c entries beside the diagonal.
double operations(double c) { return 0.5 * c * (c + 3.0); }

class FrontWalker {
    auto neighbours() const
    {
        return [this](std::int32_t k, const auto& visit) {
            for (const std::int32_t i : graph_.neighbours[at(k)]) visit(i);
        };
    }

public:
    FrontWalker(const BlockGraph& graph, const BlockAdjacency& adjacency, std::span<const std::int32_t> order)
    {
        std::vector<std::int32_t> place(graph.n_blocks(), no_block);
        for (const std::int32_t block : order) {
            if (graph.block_sizes[at(block)] == 0) continue;
            place[at(block)] = static_cast<std::int32_t>(walk_.order.size());
            walk_.order.push_back(block);
        }
        for (const std::int32_t block : walk_.order) {
            graph_.sizes.push_back(graph.block_sizes[at(block)]);
            auto& places = graph_.neighbours.emplace_back();
            for (const std::int32_t other : adjacency.of(block)) places.push_back(place[at(other)]);
            std::sort(places.begin(), places.end());
        }
        walk_.parent = grown_tree(walk_.order.size(), neighbours());
    }

    EliminationWalk run(WalkDetail detail)
    {
        heights_ = column_counts(graph_, walk_.parent);
        count_columns();
        count_rows();
        gather_fronts();
        stack_updates();
        if (detail == WalkDetail::Pattern) list_columns();
        return std::move(walk_);
    }

private:
    void count_columns()
    {
        EliminationCounts& counts = walk_.counts;
        for (std::int32_t k = 0; k < graph_.n(); ++k)
            for (std::int64_t column = 0; column < graph_.sizes[at(k)]; ++column) {
                const std::int64_t height = heights_[at(k)] - column;
                ++counts.n_unknowns;
                counts.n_entries += static_cast<std::size_t>(height);
                counts.n_operations += operations(static_cast<double>(height - 1));
            }
    }

    /// What K has, and what lies between the first entry of each row and the diagonal.
    void count_rows()
    {
        EliminationCounts& counts = walk_.counts;
        std::vector<std::int64_t> first_row(at(graph_.n()));
        for (std::int32_t k = 1; k < graph_.n(); ++k) first_row[at(k)] = first_row[at(k) - 1] + graph_.sizes[at(k) - 1];
        for (std::int32_t k = 0; k < graph_.n(); ++k) {
            std::int64_t coupled = 0, reach = 0;
            for (const std::int32_t i : graph_.neighbours[at(k)]) {
                if (i >= k) break;
                if (coupled == 0) reach = first_row[at(k)] - first_row[at(i)];
                coupled += graph_.sizes[at(i)];
            }
            for (std::int64_t row = 0; row < graph_.sizes[at(k)]; ++row) {
                counts.n_entries_of_K += static_cast<std::size_t>(coupled + row + 1);
                counts.n_profile_entries += static_cast<std::size_t>(reach + row + 1);
                counts.n_profile_operations += operations(static_cast<double>(reach + row));
            }
        }
    }

    /// A place joins the front before it where it is that one's parent and their columns are alike.
    void gather_fronts()
    {
        for (std::int32_t k = 0; k < graph_.n(); ++k) {
            const bool is_alike = k > 0 && walk_.parent[at(k) - 1] == k &&
                                  heights_[at(k)] == heights_[at(k) - 1] - graph_.sizes[at(k) - 1];
            if (!is_alike) walk_.fronts.push_back({.first = k});
            EliminationWalk::Front& front = walk_.fronts.back();
            front.end = k + 1;
            front.n_pivots += static_cast<std::size_t>(graph_.sizes[at(k)]);
            front.n_left = static_cast<std::size_t>(heights_[at(k)] - graph_.sizes[at(k)]);
        }
        const std::vector<std::int32_t> front_of = walk_.front_of_place();
        for (EliminationWalk::Front& front : walk_.fronts)
            if (const std::int32_t above = walk_.parent[at(front.end) - 1]; above != no_block)
                front.parent = front_of[at(above)];
    }

    void stack_updates()
    {
        EliminationCounts& counts = walk_.counts;
        std::vector<std::size_t> taken(walk_.fronts.size(), 0); // entries that each front takes from its children
        std::vector<std::size_t> levels(walk_.fronts.size(), 1);
        std::size_t waiting = 0;
        for (std::size_t f = 0; f < walk_.fronts.size(); ++f) {
            EliminationWalk::Front& front = walk_.fronts[f];
            waiting = waiting - taken[f] + front.n_update_entries();
            front.n_waiting = waiting;
            counts.most_waiting = std::max(counts.most_waiting, waiting);
            counts.largest_front = std::max(counts.largest_front, front.n_rows());
            counts.n_levels = std::max(counts.n_levels, levels[f]);
            if (front.parent == no_block) continue;
            taken[at(front.parent)] += front.n_update_entries();
            levels[at(front.parent)] = std::max(levels[at(front.parent)], levels[f] + 1);
        }
    }

    void list_columns()
    {
        walk_.columns.resize(walk_.order.size());
        visit_factor(walk_.parent, neighbours(), [&](std::int32_t row, std::int32_t column) {
            const auto& coupled = graph_.neighbours[at(column)];
            const bool is_in_K = std::binary_search(coupled.begin(), coupled.end(), row);
            walk_.columns[at(column)].push_back({.row = row, .is_fill = !is_in_K});
        });
    }

    EliminationWalk walk_;
    OrderedGraph graph_;                ///< of the places in the order
    std::vector<std::int64_t> heights_; ///< of the first column of L of each place, its diagonal among them
};

} // namespace

std::vector<std::int32_t> EliminationWalk::children_of(std::int32_t front) const
{
    std::vector<std::int32_t> children;
    for (std::int32_t f = 0; f < front; ++f)
        if (fronts[at(f)].parent == front) children.push_back(f);
    return children;
}

std::vector<std::int32_t> EliminationWalk::front_of_place() const
{
    std::vector<std::int32_t> front_of(order.size());
    for (std::size_t f = 0; f < fronts.size(); ++f)
        for (std::int32_t k = fronts[f].first; k < fronts[f].end; ++k) front_of[at(k)] = static_cast<std::int32_t>(f);
    return front_of;
}

EliminationWalk walk_elimination(const BlockGraph& graph, const BlockAdjacency& adjacency,
                                 std::span<const std::int32_t> order, WalkDetail detail)
{
    return FrontWalker(graph, adjacency, order).run(detail);
}

} // namespace femoop
