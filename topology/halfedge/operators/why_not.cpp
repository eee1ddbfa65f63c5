// The conditions of the operators.
#include <unordered_set>
#include <utility>
#include <vector>

#include "topology/halfedge/operators/euler_operator.h"

namespace topology {

namespace {

template <class... Entities> Refusal refusal(RefusalKind kind, Entities... entities)
{
    return {.kind = kind, .entities = {Entity(entities)...}};
}

template <class... Ids> std::optional<Refusal> why_not_there(const Solid& solid, Ids... ids)
{
    std::optional<Refusal> missing;
    const auto look = [&](auto id) {
        if (!missing && !solid.has(id)) missing = refusal(RefusalKind::NoSuchEntity, id);
    };
    (look(ids), ...);
    return missing;
}

std::optional<Refusal> why_not_an_edge(const Solid& solid, HalfEdgeId h)
{
    if (auto missing = why_not_there(solid, h)) return missing;
    if (solid.tables().is_lone(h)) return refusal(RefusalKind::LoneVertex, solid.start(h));
    return std::nullopt;
}

} // namespace

std::optional<Refusal> EulerOperator::why_not_kvfs(FaceId f) const
{
    if (auto missing = why_not_there(*solid_, f)) return missing;
    const Loop& outer = t().loops[t().faces[f].outer];
    const bool has_rings = outer.next != t().faces[f].outer;
    if (has_rings || !t().is_lone(outer.half_edge)) return refusal(RefusalKind::NotSkeletal, f);
    return std::nullopt;
}

std::optional<Refusal> EulerOperator::why_not_mev(HalfEdgeId from, HalfEdgeId to) const
{
    if (auto missing = why_not_there(*solid_, from, to)) return missing;
    if (t().start(from) != t().start(to)) return refusal(RefusalKind::DifferentVertices, from, to, t().start(from));
    return std::nullopt;
}

std::optional<Refusal> EulerOperator::why_not_kev(HalfEdgeId h) const
{
    if (auto reason = why_not_an_edge(*solid_, h)) return reason;
    if (solid_->start(h) == solid_->end(h))
        return refusal(RefusalKind::ClosedEdge, t().half_edges[h].edge, solid_->start(h));
    return std::nullopt;
}

std::optional<Refusal> EulerOperator::why_not_semv(HalfEdgeId h) const { return why_not_an_edge(*solid_, h); }

std::optional<Refusal> EulerOperator::why_not_jekv(HalfEdgeId h) const
{
    if (auto reason = why_not_kev(h)) return reason;
    const HalfEdgeId other = solid_->next_around_vertex(h);
    if (other == h || solid_->next_around_vertex(other) != h)
        return refusal(RefusalKind::NotBetweenTwoEdges, solid_->start(h));
    return std::nullopt;
}

std::optional<Refusal> EulerOperator::why_not_mvr(FaceId f) const { return why_not_there(*solid_, f); }

std::optional<Refusal> EulerOperator::why_not_kvr(LoopId ring) const
{
    if (auto reason = why_not_mfkrh(ring)) return reason;
    if (!solid_->is_lone(ring)) return refusal(RefusalKind::NotLone, ring);
    return std::nullopt;
}

std::optional<Refusal> EulerOperator::why_not_mef(HalfEdgeId from, HalfEdgeId to) const
{
    if (auto missing = why_not_there(*solid_, from, to)) return missing;
    if (t().loop(from) != t().loop(to)) return refusal(RefusalKind::DifferentLoops, from, t().loop(from), t().loop(to));
    return std::nullopt;
}

std::optional<Refusal> EulerOperator::why_not_kef(HalfEdgeId h) const
{
    if (auto reason = why_not_an_edge(*solid_, h)) return reason;
    if (t().face(h) == t().face(t().mate(h))) return refusal(RefusalKind::OneFace, t().half_edges[h].edge, t().face(h));
    return std::nullopt;
}

std::optional<Refusal> EulerOperator::why_not_kemr(HalfEdgeId h) const
{
    if (auto reason = why_not_an_edge(*solid_, h)) return reason;
    const LoopId other = t().loop(t().mate(h));
    if (t().loop(h) != other) return refusal(RefusalKind::DifferentLoops, h, t().loop(h), other);
    return std::nullopt;
}

std::optional<Refusal> EulerOperator::why_not_mekr(HalfEdgeId from, HalfEdgeId to) const
{
    if (auto missing = why_not_there(*solid_, from, to)) return missing;
    if (t().loop(from) == t().loop(to)) return refusal(RefusalKind::OneLoop, from, to);
    if (t().face(from) != t().face(to)) return refusal(RefusalKind::DifferentFaces, from, t().face(from), t().face(to));
    return std::nullopt;
}

std::optional<Refusal> EulerOperator::why_not_kfmrh(FaceId host, FaceId f) const
{
    if (auto missing = why_not_there(*solid_, host, f)) return missing;
    if (host == f) return refusal(RefusalKind::SameFace, f);
    if (t().loops[t().faces[f].outer].next != t().faces[f].outer) return refusal(RefusalKind::HasRings, f);
    return std::nullopt;
}

std::optional<Refusal> EulerOperator::why_not_mfkrh(LoopId ring) const
{
    if (auto missing = why_not_there(*solid_, ring)) return missing;
    if (solid_->is_outer(ring)) return refusal(RefusalKind::OuterLoop, ring, solid_->face(ring));
    return std::nullopt;
}

namespace {

/// Faces that are reached from one of them without passing from `ring` to its face or back.
class Reach {
public:
    Reach(const Solid& solid, LoopId ring, FaceId from) : solid_(solid), ring_(ring) { meet(from); }

    bool has(FaceId f) const { return met_.contains(f); }
    bool is_exhausted() const { return next_ == queue_.size(); }
    void advance()
    {
        const FaceId f = queue_[next_++];
        for (const LoopId l : solid_.loops(f))
            if (l != ring_) cross(l);
    }

private:
    void cross(LoopId l)
    {
        for (const HalfEdgeId h : solid_.chain(l)) {
            const LoopId beyond = solid_.loop(solid_.mate(h));
            if (beyond != ring_) meet(solid_.face(beyond));
            else if (!std::exchange(is_ring_crossed_, true)) cross(ring_);
        }
    }
    void meet(FaceId f)
    {
        if (met_.insert(f).second) queue_.push_back(f);
    }

    const Solid& solid_;
    LoopId ring_;
    std::unordered_set<FaceId> met_;
    std::vector<FaceId> queue_;
    std::size_t next_ = 0;
    bool is_ring_crossed_ = false;
};

/// Searches from both ends in turn, so that faces near one another are found at once in a large solid.
bool is_connected_without(const Solid& solid, LoopId ring, FaceId a, FaceId b)
{
    Reach from_a(solid, ring, a), from_b(solid, ring, b);
    while (!from_a.has(b) && !from_b.has(a)) {
        if (from_a.is_exhausted() || from_b.is_exhausted()) return false;
        from_a.advance();
        from_b.advance();
    }
    return true;
}

} // namespace

std::optional<Refusal> EulerOperator::why_not_ringmv(LoopId ring, FaceId to) const
{
    if (auto missing = why_not_there(*solid_, ring, to)) return missing;
    const FaceId from = solid_->face(ring);
    if (from == to) return refusal(RefusalKind::SameFace, to);
    if (solid_->is_outer(ring)) return refusal(RefusalKind::OuterLoop, ring, from);
    if (!is_connected_without(*solid_, ring, from, to)) return refusal(RefusalKind::NotConnected, ring, from, to);
    return std::nullopt;
}

std::optional<Refusal> EulerOperator::why_not_move(VertexId v) const { return why_not_there(*solid_, v); }

} // namespace topology
