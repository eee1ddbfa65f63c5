#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "topology/halfedge/solid.h"

namespace topology {

/// A solid without its dead, and where each entity's handle went. The living keep their order.
/// A journal of the solid as it was, and handles into it, do not fit the compact one.
class Renumbering {
public:
    explicit Renumbering(const Solid& solid);

    const Solid& compact() const { return compact_; }

    /// The handle in the compact solid; none of a dead entity.
    std::optional<VertexId> of(VertexId v) const { return at(vertices_, v); }
    std::optional<HalfEdgeId> of(HalfEdgeId h) const { return at(half_edges_, h); }
    std::optional<EdgeId> of(EdgeId e) const { return at(edges_, e); }
    std::optional<LoopId> of(LoopId l) const { return at(loops_, l); }
    std::optional<FaceId> of(FaceId f) const { return at(faces_, f); }

private:
    template <class Id> using Map = std::vector<Id>; // by old index, `nothing` of the dead

    template <class Id> static std::optional<Id> at(const Map<Id>& map, Id old)
    {
        if (old.index >= map.size() || map[old.index] == nothing<Id>) return std::nullopt;
        return map[old.index];
    }

    Solid compact_;
    Map<VertexId> vertices_;
    Map<HalfEdgeId> half_edges_;
    Map<EdgeId> edges_;
    Map<LoopId> loops_;
    Map<FaceId> faces_;
};

/// Leaves the dead out; see Renumbering.
Solid compact(const Solid& solid);

} // namespace topology
