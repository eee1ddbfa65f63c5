#pragma once

#include <cstdint>

#include "topology/halfedge/solid.h"

namespace topology {

/// Every kind of link in the tables.
enum class LinkKind : std::uint8_t {
    HalfEdgeStart,
    HalfEdgeEdge,
    HalfEdgeLoop,
    HalfEdgeNext,
    HalfEdgePrev,
    EdgePlus,
    EdgeMinus,
    VertexHalfEdge,
    LoopHalfEdge,
    LoopFace,
    LoopNext,
    LoopPrev,
    FaceOuter,
};
inline constexpr int n_link_kinds = 13;

/// One link bent to another entity; `row` is the index of whose link it is, `to` the index that it then names.
struct CorruptedLink {
    LinkKind kind = LinkKind::HalfEdgeStart;
    std::uint32_t row = 0, to = 0;
};

/// A solid with a broken pointer: what validate() must see, and what a student has to find. No operator takes one.
class CorruptedSolid {
public:
    CorruptedSolid(Solid sound, const CorruptedLink& link);
    const Solid& solid() const { return solid_; }

private:
    Solid solid_;
};

} // namespace topology
