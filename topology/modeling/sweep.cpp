#include "topology/modeling/sweep.h"

#include <algorithm>

namespace topology {

namespace {

std::vector<LoopId> loops_in_order(const Solid& solid, FaceId f)
{
    std::vector<LoopId> loops;
    for (const LoopId l : solid.loops(f)) loops.push_back(l);
    std::sort(loops.begin() + 1, loops.end());
    return loops;
}

std::vector<HalfEdgeId> chain_of(const Solid& solid, LoopId l)
{
    std::vector<HalfEdgeId> chain;
    for (const HalfEdgeId h : solid.chain(l)) chain.push_back(h);
    return chain;
}

/// Sweeps the loops of one face; `done` gathers what is made.
class FaceSweep {
public:
    FaceSweep(EulerOperator& op, const Motion& image) : op_(op), image_(image) {}

    void sweep_loop(LoopId l)
    {
        const Solid& solid = op_.solid();
        const std::vector<HalfEdgeId> corners = chain_of(solid, l);
        const HalfEdgeId first = strut(corners.front());
        if (corners.size() == 1) return; // a lone vertex
        HalfEdgeId left = first, closing = first;
        for (std::size_t i = 1; i < corners.size(); ++i) {
            const HalfEdgeId right = strut(corners[i]);
            const HalfEdgeId top = side(left, right, corners[i - 1]);
            if (i == 1) closing = top;
            left = right;
        }
        side(left, closing, corners.back());
    }

    Sweep done;

private:
    /// Grows the corner's image. \returns the half-edge that runs back from it
    HalfEdgeId strut(HalfEdgeId corner)
    {
        const VertexId v = op_.solid().start(corner);
        const NewEdge edge = op_.mev(corner, image_(op_.solid().point(v)));
        done.vertices.push_back({v, edge.vertex});
        return edge.plus;
    }
    /// Closes the side over h, from the image of its start to that of its end. \returns the new edge's half in the face
    HalfEdgeId side(HalfEdgeId from, HalfEdgeId to, HalfEdgeId h)
    {
        const NewFace face = op_.mef(from, to);
        const Solid& solid = op_.solid();
        done.sides.push_back({solid.start(h), solid.end(h), face.face});
        return face.plus;
    }

    EulerOperator& op_;
    const Motion& image_;
};

} // namespace

std::optional<Refusal> why_not_sweep(const EulerOperator& op, FaceId f)
{
    const Solid& solid = op.solid();
    if (!solid.has(f)) return Refusal{.kind = RefusalKind::NoSuchEntity, .entities = {f}};
    for (const LoopId l : solid.loops(f)) {
        const HalfEdgeId h = solid.half_edge(l);
        if (!solid.is_lone(l) && solid.next(h) == h)
            return Refusal{.kind = RefusalKind::SingleClosedEdge, .entities = {l, solid.start(h)}};
    }
    return std::nullopt;
}

Sweep sweep(EulerOperator& op, FaceId f, const Vector& by)
{
    return sweep(op, f, [&](const Point& p) { return p + by; });
}

Sweep sweep(EulerOperator& op, FaceId f, const Motion& image)
{
    if (const auto refusal = why_not_sweep(op, f)) throw EulerError(*refusal);
    FaceSweep swept(op, image);
    for (const LoopId l : loops_in_order(op.solid(), f)) swept.sweep_loop(l);
    return swept.done;
}

} // namespace topology
