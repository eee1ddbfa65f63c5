#include "topology/halfedge/check/corrupted_solid.h"

#include <utility>

namespace topology {

CorruptedSolid::CorruptedSolid(Solid sound, const CorruptedLink& link) : solid_(std::move(sound))
{
    Tables& t = solid_.t_;
    const std::uint32_t row = link.row;
    switch (link.kind) {
    case LinkKind::HalfEdgeStart: t.half_edges[HalfEdgeId{row}].start.index = link.to; break;
    case LinkKind::HalfEdgeEdge: t.half_edges[HalfEdgeId{row}].edge.index = link.to; break;
    case LinkKind::HalfEdgeLoop: t.half_edges[HalfEdgeId{row}].loop.index = link.to; break;
    case LinkKind::HalfEdgeNext: t.half_edges[HalfEdgeId{row}].next.index = link.to; break;
    case LinkKind::HalfEdgePrev: t.half_edges[HalfEdgeId{row}].prev.index = link.to; break;
    case LinkKind::EdgePlus: t.edges[EdgeId{row}].plus.index = link.to; break;
    case LinkKind::EdgeMinus: t.edges[EdgeId{row}].minus.index = link.to; break;
    case LinkKind::VertexHalfEdge: t.vertices[VertexId{row}].half_edge.index = link.to; break;
    case LinkKind::LoopHalfEdge: t.loops[LoopId{row}].half_edge.index = link.to; break;
    case LinkKind::LoopFace: t.loops[LoopId{row}].face.index = link.to; break;
    case LinkKind::LoopNext: t.loops[LoopId{row}].next.index = link.to; break;
    case LinkKind::LoopPrev: t.loops[LoopId{row}].prev.index = link.to; break;
    case LinkKind::FaceOuter: t.faces[FaceId{row}].outer.index = link.to; break;
    }
}

} // namespace topology
