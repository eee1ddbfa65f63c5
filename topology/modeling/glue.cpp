#include "topology/modeling/glue.h"

#include <set>
#include <vector>

#include "topology/geometry/vector.h"
#include "topology/modeling/band.h"

namespace topology {

namespace {

std::vector<HalfEdgeId> corners_of(const Solid& solid, FaceId f)
{
    std::vector<HalfEdgeId> corners;
    for (const HalfEdgeId h : solid.chain(solid.outer(f))) corners.push_back(h);
    return corners;
}

/// Do the corners of f, forward, meet those of g, backward from g's corner `first`?
bool do_meet(const Solid& solid, const std::vector<HalfEdgeId>& f, const std::vector<HalfEdgeId>& g, std::size_t first,
             double within)
{
    for (std::size_t i = 0; i < f.size(); ++i) {
        const Point& p = solid.point(solid.start(f[i]));
        const Point& q = solid.point(solid.start(g[(first + g.size() - i) % g.size()]));
        if (!(length(p - q) <= within)) return false;
    }
    return true;
}

/// The corner of g where the first one of f lies.
std::optional<HalfEdgeId> partner(const Solid& solid, FaceId f, FaceId g, double within)
{
    const std::vector<HalfEdgeId> corners = corners_of(solid, f), others = corners_of(solid, g);
    if (corners.size() != others.size() || corners.size() < 3) return std::nullopt;
    for (std::size_t i = 0; i < others.size(); ++i)
        if (do_meet(solid, corners, others, i, within)) return others[i];
    return std::nullopt;
}

/// A vertex that both faces have would be killed with the edge across.
bool share_vertices(const Solid& solid, FaceId f, FaceId g)
{
    std::set<VertexId> vertices;
    for (const HalfEdgeId h : corners_of(solid, f)) vertices.insert(solid.start(h));
    for (const HalfEdgeId h : corners_of(solid, g))
        if (!vertices.insert(solid.start(h)).second) return true;
    return false;
}

} // namespace

std::optional<Refusal> why_not_glue(const EulerOperator& op, FaceId f, FaceId g, double within)
{
    if (auto refusal = op.why_not_kfmrh(f, g)) return refusal;
    if (auto refusal = op.why_not_kfmrh(g, f)) return refusal;
    if (!partner(op.solid(), f, g, within) || share_vertices(op.solid(), f, g))
        return Refusal{.kind = RefusalKind::NotFaceToFace, .entities = {f, g}};
    return std::nullopt;
}

void glue(EulerOperator& op, FaceId f, FaceId g, double within)
{
    if (const auto refusal = why_not_glue(op, f, g, within)) throw EulerError(*refusal);
    const Solid& solid = op.solid();
    const HalfEdgeId from = solid.half_edge(solid.outer(f)), to = *partner(solid, f, g, within);
    const std::vector<HalfEdgeId> rim = corners_of(solid, f);
    op.kfmrh(f, g);
    for (const HalfEdgeId h : add_band(op, from, to)) op.kev(solid.mate(h));
    // Each face of the band has two edges left; the half-edge beyond that of the rim keeps its face.
    for (const HalfEdgeId h : rim) op.kef(solid.mate(h));
}

} // namespace topology
