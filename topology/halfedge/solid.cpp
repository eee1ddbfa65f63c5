#include "topology/halfedge/solid.h"

namespace topology {

Counts Solid::counts() const
{
    return {.vertices = t_.vertices.n_living(),
            .edges = t_.edges.n_living(),
            .half_edges = t_.half_edges.n_living(),
            .faces = t_.faces.n_living(),
            .loops = t_.loops.n_living()};
}

std::optional<EdgeId> Solid::edge(HalfEdgeId h) const
{
    if (t_.is_lone(h)) return std::nullopt;
    return t_.half_edges[h].edge;
}

Circle<HalfEdgeId> Solid::chain(LoopId l) const
{
    return {t_, half_edge(l), [](const Tables& t, HalfEdgeId h) { return t.next(h); }};
}

Circle<HalfEdgeId> Solid::fan(VertexId v) const
{
    return {t_, half_edge(v), [](const Tables& t, HalfEdgeId h) { return t.next_around_vertex(h); }};
}

Circle<LoopId> Solid::loops(FaceId f) const
{
    return {t_, outer(f), [](const Tables& t, LoopId l) { return t.loops[l].next; }};
}

void Solid::reserve(const Counts& counts)
{
    t_.vertices.reserve(counts.vertices);
    t_.half_edges.reserve(counts.half_edges);
    t_.edges.reserve(counts.edges);
    t_.loops.reserve(counts.loops);
    t_.faces.reserve(counts.faces);
}

std::size_t Solid::bytes() const
{
    return t_.vertices.bytes() + t_.half_edges.bytes() + t_.edges.bytes() + t_.loops.bytes() + t_.faces.bytes();
}

} // namespace topology
