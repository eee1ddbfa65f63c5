#pragma once

#include <cstdint>
#include <vector>

#include "femoop/solver/index.h"

namespace femoop {

/// The elimination tree of 0 .. n - 1, -1 of a root. `neighbours(k, visit)` calls visit(i) for all that k is coupled
/// with; those after k are passed over.
///
/// Source  [Liu1990, algorithm 4.2]
template <class Neighbours> std::vector<std::int32_t> grown_tree(std::size_t n, const Neighbours& neighbours)
{
    std::vector<std::int32_t> parent(n, -1);
    std::vector<std::int32_t> ancestor(n, -1); // shortens paths for those who come later
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(n); ++k)
        neighbours(k, [&](std::int32_t i) {
            while (i != -1 && i < k) {
                const std::int32_t next = ancestor[at(i)];
                ancestor[at(i)] = k;
                if (next == -1) parent[at(i)] = k;
                i = next;
            }
        });
    return parent;
}

/// Calls visit(k, i) for every entry of L below its diagonal, row by row: paths in the tree, from the neighbours of k
/// up to k.
template <class Neighbours, class Visit>
void visit_factor(const std::vector<std::int32_t>& parent, const Neighbours& neighbours, const Visit& visit)
{
    std::vector<std::int32_t> seen_by(parent.size(), -1);
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(parent.size()); ++k) {
        seen_by[at(k)] = k;
        neighbours(k, [&](std::int32_t i) {
            for (; i < k && seen_by[at(i)] != k; i = parent[at(i)]) {
                visit(k, i);
                seen_by[at(i)] = k;
            }
        });
    }
}

} // namespace femoop
