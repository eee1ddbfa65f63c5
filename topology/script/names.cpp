#include "topology/script/names.h"

namespace topology {

namespace {

std::string half_edge_name(const Names& names, HalfEdgeId h, const Solid& solid)
{
    const std::string number = "%" + std::to_string(h.index + 1);
    if (!solid.has(h)) return number;
    const std::string start = names.vertices.of(solid.start(h));
    if (!solid.edge(h)) return start + " (" + number + ")";
    return start + ">" + names.vertices.of(solid.end(h)) + " (" + number + ")";
}

std::string edge_name(const Names& names, EdgeId e, const Solid& solid)
{
    if (!solid.has(e)) return table_name(e);
    const HalfEdgeId h = solid.minus(e);
    return names.vertices.of(solid.start(h)) + "-" + names.vertices.of(solid.end(h));
}

} // namespace

std::string Names::of(Entity entity, const Solid& solid) const
{
    switch (entity.kind) {
    case EntityKind::Vertex: return vertices.of(VertexId{entity.index});
    case EntityKind::Face: return faces.of(FaceId{entity.index});
    case EntityKind::HalfEdge: return half_edge_name(*this, HalfEdgeId{entity.index}, solid);
    case EntityKind::Edge: return edge_name(*this, EdgeId{entity.index}, solid);
    case EntityKind::Loop: break;
    }
    return table_name(entity);
}

} // namespace topology
