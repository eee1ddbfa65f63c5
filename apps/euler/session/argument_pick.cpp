#include "apps/euler/session/argument_pick.h"

namespace euler {

namespace {

using topology::Entity;
using topology::EntityKind;
using topology::HalfEdgeId;

// Whether a half-edge is what a click on this means.
bool belongs(const topology::Solid& solid, HalfEdgeId h, Entity clicked)
{
    switch (clicked.kind) {
    case EntityKind::Vertex: return Entity(solid.start(h)) == clicked;
    case EntityKind::Edge: return solid.edge(h) && Entity(*solid.edge(h)) == clicked;
    case EntityKind::Loop: return Entity(solid.loop(h)) == clicked;
    case EntityKind::Face: return Entity(solid.face(h)) == clicked;
    case EntityKind::HalfEdge: return Entity(h) == clicked;
    }
    return false;
}

Entity only_legal_half_edge(const topology::Solid& solid, Entity clicked, const std::vector<Entity>& legal)
{
    Entity found = clicked;
    for (const Entity entity : legal) {
        if (entity.kind != EntityKind::HalfEdge || !belongs(solid, HalfEdgeId{entity.index}, clicked)) continue;
        if (found != clicked) return clicked; // more than one
        found = entity;
    }
    return found;
}

} // namespace

Entity as_argument(const topology::Solid& solid, ArgumentKind wanted, Entity clicked, const std::vector<Entity>& legal)
{
    const bool is_half_edge = clicked.kind == EntityKind::HalfEdge;
    if (wanted == ArgumentKind::Face && is_half_edge) return solid.face(HalfEdgeId{clicked.index});
    if (wanted == ArgumentKind::Face && clicked.kind == EntityKind::Loop)
        return solid.face(topology::LoopId{clicked.index});
    if (wanted == ArgumentKind::Vertex) return is_half_edge ? Entity(solid.start(HalfEdgeId{clicked.index})) : clicked;
    const bool wants_half_edge = wanted == ArgumentKind::Corner || wanted == ArgumentKind::HalfEdge ||
                                 wanted == ArgumentKind::Ring;
    if (!wants_half_edge || is_half_edge) return clicked;
    return only_legal_half_edge(solid, clicked, legal);
}

} // namespace euler
