#pragma once

#include <limits>

#include "topology/geometry/point.h"
#include "topology/halfedge/ids.h"

namespace topology {

/// The handle of nothing, as a link inside the tables below. Queries of a Solid answer with std::optional instead.
template <class Id> inline constexpr Id nothing{std::numeric_limits<std::uint32_t>::max()};

/// One side of an edge: it runs from `start` to the start of `next`, with its face on the left, seen from outside.
///
///            next
///        o<-------- (mate: the other half of `edge`)
///        o-------->o
///   start   this    start of next
///
/// A half-edge without edge is the lone vertex `start`, the whole of its loop: it is its own next, prev and mate.
struct HalfEdge {
    VertexId start = nothing<VertexId>;
    EdgeId edge = nothing<EdgeId>;
    LoopId loop = nothing<LoopId>;
    HalfEdgeId next = nothing<HalfEdgeId>, prev = nothing<HalfEdgeId>;

    friend bool operator==(const HalfEdge&, const HalfEdge&) = default;
};

/// Two opposite half-edges. The edge runs as its plus half does.
struct Edge {
    HalfEdgeId plus = nothing<HalfEdgeId>, minus = nothing<HalfEdgeId>;

    friend bool operator==(const Edge&, const Edge&) = default;
};

struct Vertex {
    HalfEdgeId half_edge = nothing<HalfEdgeId>; ///< one of those that start here
    Point point;

    friend bool operator==(const Vertex&, const Vertex&) = default;
};

/// A closed chain of half-edges, one boundary of its face. `next` and `prev` chain the loops of the face in a circle.
struct Loop {
    HalfEdgeId half_edge = nothing<HalfEdgeId>; ///< one of the chain
    FaceId face = nothing<FaceId>;
    LoopId next = nothing<LoopId>, prev = nothing<LoopId>;

    friend bool operator==(const Loop&, const Loop&) = default;
};

/// A piece of surface without handles; its loops other than the outer one are its rings.
struct Face {
    LoopId outer = nothing<LoopId>;

    friend bool operator==(const Face&, const Face&) = default;
};

} // namespace topology
