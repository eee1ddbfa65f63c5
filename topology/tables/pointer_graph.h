#pragma once

#include <string_view>
#include <vector>

#include "topology/halfedge/solid.h"

namespace topology {

/// A link as an arrow from one entity to another.
struct Pointer {
    Entity from, to;
    std::string_view label; ///< "next"

    friend bool operator==(const Pointer&, const Pointer&) = default;
};

/// The links of an entity that lives: a half-edge's start, edge, loop, next, prev and mate; an edge's plus and minus
/// half; a vertex's half-edge; a loop's half-edge and face; a face's outer loop and rings. A lone vertex's half-edge
/// has no edge, and is its own next, prev and mate.
std::vector<Pointer> pointers(const Solid& solid, Entity entity);

/// What is reached from an entity in so many links, the entity itself first, and all links among these.
struct PointerGraph {
    std::vector<Entity> nodes;
    std::vector<Pointer> pointers;
};
PointerGraph pointer_graph(const Solid& solid, Entity entity, int reach = 1);

} // namespace topology
