#include "femoop/methods/derivation/renumbering.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "femoop/solver/ordering.h"

namespace femoop::derivation {

namespace {

using Places = std::vector<std::int32_t>; ///< of each unknown in the matrix

/// The block of each unknown: those of one node stand one after the other.
Places blocks_of(const SystemTrace& system)
{
    Places blocks;
    for (std::size_t i = 0; i < system.unknowns.size(); ++i) {
        const bool begins = i > 0 && system.unknowns[i].node != system.unknowns[i - 1].node;
        blocks.push_back(i == 0 ? 0 : blocks.back() + (begins ? 1 : 0));
    }
    return blocks;
}

template <class Visit> void each_entry(const SparseMatrix& K, Visit&& visit)
{
    for (Eigen::Index column = 0; column < K.outerSize(); ++column)
        for (SparseMatrix::InnerIterator entry(K, column); entry; ++entry)
            if (entry.value() != 0.0) visit(static_cast<std::size_t>(entry.row()), static_cast<std::size_t>(column));
}

BlockGraph graph_of(const SystemTrace& system, const Places& blocks)
{
    BlockGraph graph;
    graph.block_sizes.assign(blocks.empty() ? 0 : static_cast<std::size_t>(blocks.back()) + 1, 0);
    for (const std::int32_t block : blocks) ++graph.block_sizes[static_cast<std::size_t>(block)];
    each_entry(system.K, [&](std::size_t row, std::size_t column) {
        if (blocks[row] < blocks[column]) graph.add_clique(std::array{blocks[row], blocks[column]});
    });
    return graph;
}

Places placed(const Places& blocks, const std::vector<std::int32_t>& order)
{
    Places places(blocks.size());
    std::int32_t next = 0;
    for (const std::int32_t block : order)
        for (std::size_t i = 0; i < blocks.size(); ++i)
            if (blocks[i] == block) places[i] = next++;
    return places;
}

Reach reach(const SparseMatrix& K, const Places& places)
{
    std::vector<std::int32_t> first(places.size());
    std::iota(first.begin(), first.end(), 0);
    each_entry(K, [&](std::size_t row, std::size_t column) {
        std::int32_t& least = first[static_cast<std::size_t>(places[row])];
        least = std::min(least, places[column]);
    });
    Reach reach;
    for (std::size_t row = 0; row < first.size(); ++row) {
        const std::size_t length = row + 1 - static_cast<std::size_t>(first[row]);
        reach.half_bandwidth = std::max(reach.half_bandwidth, length);
        reach.profile += length;
    }
    return reach;
}

} // namespace

Renumbering renumbering_of(const SystemTrace& system)
{
    const Places blocks = blocks_of(system);
    Places on_paper(blocks.size());
    std::iota(on_paper.begin(), on_paper.end(), 0);
    const BlockAdjacency adjacency(graph_of(system, blocks));
    const Places renumbered = placed(blocks, elimination_order(adjacency, Ordering::CuthillMcKee));
    return {reach(system.K, on_paper), reach(system.K, renumbered)};
}

} // namespace femoop::derivation
