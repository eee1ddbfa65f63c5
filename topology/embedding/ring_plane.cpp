#include "topology/embedding/ring_plane.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "topology/embedding/flat_face.h"

namespace topology {

namespace {

struct Distance {
    VertexId vertex;
    double height; ///< without sign
};

Distance farthest(const FlatFace& face, const Solid& solid, LoopId l)
{
    Distance found{solid.start(solid.half_edge(l)), 0.0};
    for (const HalfEdgeId h : solid.chain(l)) {
        const VertexId v = solid.start(h);
        if (const double height = std::abs(face.height(solid.point(v))); height > found.height) found = {v, height};
    }
    return found;
}

std::optional<OffPlane> ring_off_plane(const Solid& solid, LoopId ring)
{
    const FaceId f = solid.face(ring);
    const Box box = FlatFace(solid, f, 0.0).box();
    const double tolerance = 1e-9 * length(box.most - box.least);
    const FlatFace face(solid, f, tolerance);
    if (!face.has_area()) return std::nullopt;
    const Distance bent = farthest(face, solid, solid.outer(f)), found = farthest(face, solid, ring);
    if (found.height <= std::max(bent.height, tolerance)) return std::nullopt;
    return OffPlane{found.vertex, f};
}

} // namespace

std::optional<OffPlane> off_plane(const Solid& after, const Change& change)
{
    using enum OperatorKind;
    if (change.kind != KEMR && change.kind != KFMRH && change.kind != RINGMV && change.kind != MVR) return std::nullopt;
    for (const std::vector<Entity>& touched : {change.created, change.changed})
        for (const Entity entity : touched) {
            const LoopId l{entity.index};
            if (entity.kind != EntityKind::Loop || !after.has(l) || after.is_outer(l)) continue;
            if (const auto found = ring_off_plane(after, l)) return found;
        }
    return std::nullopt;
}

} // namespace topology
