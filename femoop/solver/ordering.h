#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "femoop/solver/block_graph.h"

namespace femoop {

/// In which order blocks are eliminated.
enum class Ordering : std::uint8_t {
    Natural,         ///< as they are numbered
    CuthillMcKee,    ///< reverse Cuthill-McKee: a narrow profile, for the skyline solver
    MinimumDegree,   ///< approximate minimum degree
    NestedDissection ///< in space where positions are known, else by METIS where the library is built with it
};

inline constexpr std::array all_orderings{Ordering::Natural, Ordering::CuthillMcKee, Ordering::MinimumDegree,
                                          Ordering::NestedDissection};
std::string_view name(Ordering ordering); ///< "natural", "cuthill-mckee", "minimum-degree", "nested-dissection"
std::optional<Ordering> ordering_named(std::string_view name);

/// The blocks in the order of elimination; for MinimumDegree and NestedDissection a postorder of the elimination tree,
/// so that columns of one supernode are neighbours. `positions` of the blocks may be empty.
/// Source  [GeorgeLiu1981, ch. 4 and 5]
std::vector<std::int32_t> elimination_order(const BlockAdjacency& adjacency, Ordering ordering,
                                            std::span<const Eigen::Vector3d> positions = {});

/// The elimination tree of the blocks eliminated as numbered by `order`: the parent of each position, or -1.
/// Source  [Liu1990]
std::vector<std::int32_t> elimination_tree(const BlockAdjacency& adjacency, const std::vector<std::int32_t>& order);

/// The order with every subtree of the elimination tree contiguous, its root last; the fill stays the same.
std::vector<std::int32_t> postordered(const std::vector<std::int32_t>& order, const std::vector<std::int32_t>& parent);

/// What elimination in this order costs, in multiplications of one block with another: the sum of squares of the
/// column counts of L.
double elimination_cost(const BlockAdjacency& adjacency, const std::vector<std::int32_t>& order);

} // namespace femoop
