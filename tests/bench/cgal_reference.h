#pragma once

#include <cstddef>

namespace bench {

/// Seconds that CGAL's HalfedgeDS in vectors, with room for all, needs to draw the grid of `cremona bench halfedge` by
/// its own Euler operators, split_vertex and split_face.
double cgal_grid(std::size_t n);

} // namespace bench
