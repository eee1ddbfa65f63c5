#pragma once

#include "topology/halfedge/entities.h"
#include "topology/halfedge/table.h"

namespace topology {

/// The five tables that are a solid, and the few steps along their links that everything else is said with.
struct Tables {
    Table<VertexId, Vertex> vertices;
    Table<HalfEdgeId, HalfEdge> half_edges;
    Table<EdgeId, Edge> edges;
    Table<LoopId, Loop> loops;
    Table<FaceId, Face> faces;

    HalfEdgeId next(HalfEdgeId h) const { return half_edges[h].next; }
    HalfEdgeId prev(HalfEdgeId h) const { return half_edges[h].prev; }
    VertexId start(HalfEdgeId h) const { return half_edges[h].start; }
    LoopId loop(HalfEdgeId h) const { return half_edges[h].loop; }
    FaceId face(HalfEdgeId h) const { return loops[half_edges[h].loop].face; }
    bool is_lone(HalfEdgeId h) const { return half_edges[h].edge == nothing<EdgeId>; }

    /// The other half of the same edge; the half-edge of a lone vertex is its own mate.
    HalfEdgeId mate(HalfEdgeId h) const
    {
        const EdgeId e = half_edges[h].edge;
        if (e == nothing<EdgeId>) return h;
        const Edge& edge = edges[e];
        return HalfEdgeId{edge.plus.index ^ edge.minus.index ^ h.index};
    }
    /// The next half-edge that starts where h does, clockwise seen from outside.
    HalfEdgeId next_around_vertex(HalfEdgeId h) const { return next(mate(h)); }

    friend bool operator==(const Tables&, const Tables&) = default;
};

} // namespace topology
