#include "femoop/solver/block_graph.h"

#include <numeric>

namespace femoop {

std::size_t BlockGraph::n_unknowns() const
{
    return std::accumulate(block_sizes.begin(), block_sizes.end(), std::size_t{0},
                           [](std::size_t sum, std::int32_t size) { return sum + static_cast<std::size_t>(size); });
}

void BlockGraph::add_clique(std::span<const std::int32_t> blocks)
{
    clique_blocks.insert(clique_blocks.end(), blocks.begin(), blocks.end());
    clique_start.push_back(static_cast<std::int32_t>(clique_blocks.size()));
}

namespace {

/// Calls visit(a, b) for every ordered pair of different blocks with unknowns in a clique; a pair may come again.
template <class Visit> void visit_pairs(const BlockGraph& graph, Visit&& visit)
{
    const auto is_empty = [&](std::int32_t block) { return graph.block_sizes[static_cast<std::size_t>(block)] == 0; };
    for (std::size_t i = 0; i < graph.n_cliques(); ++i)
        for (const std::int32_t a : graph.clique(i)) {
            if (is_empty(a)) continue;
            for (const std::int32_t b : graph.clique(i))
                if (a != b && !is_empty(b)) visit(static_cast<std::size_t>(a), b);
        }
}

} // namespace

BlockAdjacency::BlockAdjacency(const BlockGraph& graph) : start(graph.n_blocks() + 1, 0)
{
    const std::size_t n = graph.n_blocks();
    visit_pairs(graph, [&](std::size_t a, std::int32_t) { ++start[a + 1]; });
    std::partial_sum(start.begin(), start.end(), start.begin());
    neighbours.resize(static_cast<std::size_t>(start[n]));
    std::vector<std::int32_t> next(start.begin(), start.end() - 1);
    visit_pairs(graph, [&](std::size_t a, std::int32_t b) { neighbours[static_cast<std::size_t>(next[a]++)] = b; });

    std::vector<std::int32_t>& last_seen_by = next; // its work is done
    last_seen_by.assign(n, -1);
    std::int32_t kept = 0;
    for (std::size_t a = 0; a < n; ++a) {
        const std::int32_t first = start[a];
        start[a] = kept;
        for (std::int32_t at = first; at < start[a + 1]; ++at) {
            const std::int32_t b = neighbours[static_cast<std::size_t>(at)];
            if (last_seen_by[static_cast<std::size_t>(b)] == static_cast<std::int32_t>(a)) continue;
            last_seen_by[static_cast<std::size_t>(b)] = static_cast<std::int32_t>(a);
            neighbours[static_cast<std::size_t>(kept++)] = b;
        }
    }
    start[n] = kept;
    neighbours.resize(static_cast<std::size_t>(kept));
}

} // namespace femoop
