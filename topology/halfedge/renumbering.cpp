#include "topology/halfedge/renumbering.h"

namespace topology {

namespace {

template <class Id, class Entity> std::vector<Id> order_of_living(const Table<Id, Entity>& table)
{
    std::vector<Id> map(table.n_rows(), nothing<Id>);
    std::uint32_t next = 0;
    for (const Id id : table) map[id.index] = Id{next++};
    return map;
}

} // namespace

Renumbering::Renumbering(const Solid& solid)
    : vertices_(order_of_living(solid.vertices())),
      half_edges_(order_of_living(solid.half_edges())),
      edges_(order_of_living(solid.edges())),
      loops_(order_of_living(solid.loops())),
      faces_(order_of_living(solid.faces()))
{
    compact_.reserve(solid.counts());
    const Tables& old = solid.tables();
    Tables& t = compact_.t_;
    for (const VertexId v : old.vertices)
        t.vertices.add({half_edges_[old.vertices[v].half_edge.index], old.vertices[v].point});
    for (const HalfEdgeId i : old.half_edges) {
        const HalfEdge& h = old.half_edges[i];
        t.half_edges.add({vertices_[h.start.index], old.is_lone(i) ? h.edge : edges_[h.edge.index],
                          loops_[h.loop.index], half_edges_[h.next.index], half_edges_[h.prev.index]});
    }
    for (const EdgeId e : old.edges)
        t.edges.add({half_edges_[old.edges[e].plus.index], half_edges_[old.edges[e].minus.index]});
    for (const LoopId i : old.loops) {
        const Loop& l = old.loops[i];
        t.loops.add({half_edges_[l.half_edge.index], faces_[l.face.index], loops_[l.next.index], loops_[l.prev.index]});
    }
    for (const FaceId f : old.faces) t.faces.add({loops_[old.faces[f].outer.index]});
}

Solid compact(const Solid& solid) { return Renumbering(solid).compact(); }

} // namespace topology
