#pragma once

#include <cstddef>

#include "topology/halfedge/operators/euler_operator.h"

namespace cli {

/// Draws a grid of n by n quadrilaterals by MVFS, MEV and MEF: (n + 1)^2 vertices, 2 n (n + 1) edges, and n^2 faces
/// with the one around them. \returns how many operators that took
std::size_t draw_grid(topology::EulerOperator& op, std::size_t n);
topology::Counts grid_counts(std::size_t n);

/// What the grid of `cremona bench halfedge` costs, in seconds.
struct HalfEdgeBench {
    std::size_t operators = 0;
    double build = 0.0;           ///< without journal
    double build_journaled = 0.0; ///< with the journal written
    double undo = 0.0;            ///< of all of it
    double validate = 0.0;
    double bytes_per_edge = 0.0; ///< of the tables, points included, without journal
};
HalfEdgeBench bench_halfedge(std::size_t n);

} // namespace cli
