#include "topology/tables/pointer_graph.h"

#include <algorithm>

namespace topology {

namespace {

std::vector<Pointer> of(const Solid& solid, HalfEdgeId h)
{
    std::vector<Pointer> found{{h, solid.start(h), "start"},
                               {h, solid.loop(h), "loop"},
                               {h, solid.next(h), "next"},
                               {h, solid.prev(h), "prev"},
                               {h, solid.mate(h), "mate"}};
    if (const auto e = solid.edge(h)) found.push_back({h, *e, "edge"});
    return found;
}

std::vector<Pointer> of(const Solid& solid, FaceId f)
{
    std::vector<Pointer> found;
    for (const LoopId l : solid.loops(f)) found.push_back({f, l, found.empty() ? "outer" : "ring"});
    return found;
}

bool has(const std::vector<Entity>& nodes, Entity entity)
{
    return std::find(nodes.begin(), nodes.end(), entity) != nodes.end();
}

} // namespace

std::vector<Pointer> pointers(const Solid& solid, Entity entity)
{
    const VertexId v{entity.index};
    const EdgeId e{entity.index};
    const LoopId l{entity.index};
    switch (entity.kind) {
    case EntityKind::HalfEdge: return of(solid, HalfEdgeId{entity.index});
    case EntityKind::Face: return of(solid, FaceId{entity.index});
    case EntityKind::Vertex: return {{v, solid.half_edge(v), "half-edge"}};
    case EntityKind::Edge: return {{e, solid.plus(e), "plus"}, {e, solid.minus(e), "minus"}};
    case EntityKind::Loop: return {{l, solid.half_edge(l), "half-edge"}, {l, solid.face(l), "face"}};
    }
    return {};
}

PointerGraph pointer_graph(const Solid& solid, Entity entity, int reach)
{
    PointerGraph graph{.nodes = {entity}};
    std::size_t n_known = 0;
    for (; reach > 0; --reach) {
        const std::size_t n_now = graph.nodes.size();
        for (; n_known < n_now; ++n_known)
            for (const Pointer& pointer : pointers(solid, graph.nodes[n_known]))
                if (!has(graph.nodes, pointer.to)) graph.nodes.push_back(pointer.to);
    }
    for (const Entity node : graph.nodes)
        for (const Pointer& pointer : pointers(solid, node))
            if (has(graph.nodes, pointer.to)) graph.pointers.push_back(pointer);
    return graph;
}

} // namespace topology
