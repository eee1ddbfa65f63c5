#pragma once

#include <cstdint>
#include <vector>

namespace femoop {

/// A graph whose vertices are numbered in the order of elimination, and the unknowns of each.
struct OrderedGraph {
    std::vector<std::vector<std::int32_t>> neighbours;
    std::vector<std::int64_t> sizes;

    std::int32_t n() const { return static_cast<std::int32_t>(sizes.size()); }
};

/// Unknowns in the first column of L of each vertex, its own among them, found without L itself in a time that grows
/// with the graph alone: row i of L is a subtree of the elimination tree, and a column has one more of each subtree
/// that has a leaf there.
///
/// Source  [Davis2006, section 4.5]
std::vector<std::int64_t> column_counts(const OrderedGraph& graph, const std::vector<std::int32_t>& parent);

} // namespace femoop
