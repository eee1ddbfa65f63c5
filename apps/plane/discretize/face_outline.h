#pragma once

#include <cstddef>
#include <vector>

#include "apps/plane/discretize/drawing.h"

namespace discretize {

/// Half-edges one after the other around a part of a face, which lies to their left.
using OutlineLoop = std::vector<topology::HalfEdgeId>;

/// What a face with material is made of for a mesh: edges that dangle in it, and points, are left out unless something
/// is at stake there.
struct FaceOutline {
    std::size_t face = 0; ///< of the drawing's
    femoop::plane::RegionId region;
    std::vector<OutlineLoop> loops;                 ///< the outer one first
    std::vector<topology::EdgeId> inner_edges;      ///< that dangle in it, with a support or a load
    std::vector<topology::VertexId> inner_vertices; ///< on none of all these, with a support, a load or a size
};

/// Those of all faces with material, region by region. \pre the drawing is sound
std::vector<FaceOutline> outlines_of(const Drawing& drawing);

/// A part of a drawn curve from vertex to vertex, in its direction.
struct CurvePiece {
    topology::EdgeId edge;
    bool is_forward = true; ///< the edge's plus half runs along the curve
    double length = 0.0;
};
std::vector<std::vector<CurvePiece>> pieces_of_curves(const Drawing& drawing); ///< of each curve of the model

} // namespace discretize
