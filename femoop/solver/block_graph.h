#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace femoop {

/// What a system of equations is made of: blocks of unknowns, and cliques of blocks that an element couples.
///
///      o---o---o      a block is a node with its free degrees of freedom (or what else comes and goes together);
///      |   |          a clique is the blocks of one member: its two nodes, three blocks where it has ends of its own
///      o---o
///
/// Ordering and symbolic work are done on blocks: a plane frame has a third of the vertices and a ninth of the edges
/// that its unknowns have.
struct BlockGraph {
    std::vector<std::int32_t> block_sizes;     ///< unknowns of each block; 0 where all are prescribed
    std::vector<std::int32_t> clique_start{0}; ///< of each clique in clique_blocks, and the end of the last one
    std::vector<std::int32_t> clique_blocks;
    std::vector<Eigen::Vector3d> positions; ///< of each block in space, for nested dissection; or empty

    std::size_t n_blocks() const { return block_sizes.size(); }
    std::size_t n_cliques() const { return clique_start.size() - 1; }
    std::size_t n_unknowns() const;

    /// Couples blocks, all with all. Cliques are numbered in the order in which they are added.
    void add_clique(std::span<const std::int32_t> blocks);
    std::span<const std::int32_t> clique(std::size_t i) const
    {
        const auto start = static_cast<std::size_t>(clique_start[i]);
        return std::span(clique_blocks).subspan(start, static_cast<std::size_t>(clique_start[i + 1]) - start);
    }
};

/// The neighbours of each block: blocks that share a clique with it, each once, itself left out, in no order.
/// Blocks without unknowns have none and are no one's.
struct BlockAdjacency {
    std::vector<std::int32_t> start; ///< [blocks + 1] into neighbours
    std::vector<std::int32_t> neighbours;

    explicit BlockAdjacency(const BlockGraph& graph);

    std::size_t n_blocks() const { return start.size() - 1; }
    std::span<const std::int32_t> of(std::int32_t block) const
    {
        const auto first = static_cast<std::size_t>(start[static_cast<std::size_t>(block)]);
        const auto last = static_cast<std::size_t>(start[static_cast<std::size_t>(block) + 1]);
        return std::span(neighbours).subspan(first, last - first);
    }
};

} // namespace femoop
