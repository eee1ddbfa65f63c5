#pragma once

#include <cstddef>

#include "topology/meshing/mesh_domain.h"

namespace cli {

/// The unit square with holes of radius 0.1 at its centre and 0.05 at (0.2, 0.2), (0.8, 0.2), (0.8, 0.8), (0.2, 0.8).
/// \param size  of the parts of sides and circles, as near as whole numbers of them allow; at least 8 around a hole
topology::MeshDomain square_with_five_holes(double size);

/// Of about so many equilateral triangles that fill it: sqrt(4 area / (sqrt 3 n)).
double edge_length_of(std::size_t n_triangles);

/// What `cremona bench mesh` makes, and what it takes, in seconds.
struct MeshBench {
    std::size_t triangles = 0, vertices = 0;
    double min_angle = 0.0; ///< [degrees]
    double seconds = 0.0;   ///< of meshing alone
};
/// \param n_triangles  about as many are wanted
MeshBench bench_mesh(std::size_t n_triangles);

} // namespace cli
