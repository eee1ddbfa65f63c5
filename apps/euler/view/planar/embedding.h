#pragma once

#include "apps/euler/view/solid/half_edge_paths.h"
#include "topology/halfedge/solid.h"
#include "ui/paint/geometry.h"

#include <unordered_map>
#include <vector>

namespace euler {

/// The vertices and edges that hang together with one loop, drawn in the disc of radius 1 so that nothing crosses and
/// the loop's face is all around. y is up; faces lie left of their half-edges.
struct Embedding {
    std::unordered_map<topology::VertexId, ui::Point> vertices;
    std::unordered_map<topology::EdgeId, std::vector<ui::Point>> curves; ///< as the plus half runs; else it is straight
    std::vector<topology::LoopId> loops;                                 ///< all of the part, the one around first
};

/// Edges are straight where that keeps all faces convex, as in every polyhedron without rings. Else they are curves, so
/// that closed edges, struts and edges with the same ends show too.
/// \pre the part is drawn on a sphere: its shell has genus 0
Embedding embedding(const topology::Solid& solid, topology::LoopId around);

} // namespace euler
