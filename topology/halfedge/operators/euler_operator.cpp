#include "topology/halfedge/operators/euler_operator.h"

#include <stdexcept>

#include "topology/halfedge/operators/surgery.h"

namespace topology {

namespace {

void require(const std::optional<Refusal>& refusal)
{
    if (refusal) throw EulerError(*refusal);
}

NewEdge newest_edge(const Tables& t)
{
    const EdgeId e = t.edges.last();
    return {e, t.edges[e].minus, t.edges[e].plus, t.vertices.last()};
}

LoneVertex newest_vertex(const Tables& t)
{
    const LoopId l = t.loops.last();
    return {t.loops[l].face, l, t.half_edges.last(), t.vertices.last()};
}

} // namespace

void EulerOperator::tell(const Change& change) const
{
    for (Observer* observer : observers_) observer->changed(change);
}

void EulerOperator::commit(const Step& step)
{
    if (journal_ != nullptr) journal_->add(step);
    if (!observers_.empty()) tell(change(t(), step));
}

LoneVertex EulerOperator::mvfs(const Point& point)
{
    commit(surgery::mvfs(solid_->t_, point));
    return newest_vertex(t());
}

void EulerOperator::kvfs(FaceId f)
{
    require(why_not_kvfs(f));
    commit(surgery::kvfs(solid_->t_, f));
}

NewEdge EulerOperator::mev(HalfEdgeId from, HalfEdgeId to, const Point& point)
{
    require(why_not_mev(from, to));
    commit(surgery::mev(solid_->t_, from, to, point));
    return newest_edge(t());
}

void EulerOperator::kev(HalfEdgeId h)
{
    require(why_not_kev(h));
    commit(surgery::kev(solid_->t_, h, OperatorKind::KEV));
}

NewEdge EulerOperator::semv(HalfEdgeId h, const Point& point)
{
    require(why_not_semv(h));
    commit(surgery::semv(solid_->t_, h, point));
    return newest_edge(t());
}

void EulerOperator::jekv(HalfEdgeId h)
{
    require(why_not_jekv(h));
    commit(surgery::kev(solid_->t_, h, OperatorKind::JEKV));
}

LoneVertex EulerOperator::mvr(FaceId f, const Point& point)
{
    require(why_not_mvr(f));
    commit(surgery::mvr(solid_->t_, f, point));
    return newest_vertex(t());
}

void EulerOperator::kvr(LoopId ring)
{
    require(why_not_kvr(ring));
    commit(surgery::kvr(solid_->t_, ring));
}

NewFace EulerOperator::mef(HalfEdgeId from, HalfEdgeId to)
{
    require(why_not_mef(from, to));
    commit(surgery::mef(solid_->t_, from, to));
    const EdgeId e = t().edges.last();
    return {e, t().edges[e].minus, t().edges[e].plus, t().faces.last(), t().loops.last()};
}

void EulerOperator::kef(HalfEdgeId h)
{
    require(why_not_kef(h));
    commit(surgery::kef(solid_->t_, h));
}

LoopId EulerOperator::kemr(HalfEdgeId h)
{
    require(why_not_kemr(h));
    commit(surgery::kemr(solid_->t_, h));
    return t().loops.last();
}

Bridge EulerOperator::mekr(HalfEdgeId from, HalfEdgeId to)
{
    require(why_not_mekr(from, to));
    commit(surgery::mekr(solid_->t_, from, to));
    const EdgeId e = t().edges.last();
    return {e, t().edges[e].minus, t().edges[e].plus};
}

void EulerOperator::kfmrh(FaceId host, FaceId f)
{
    require(why_not_kfmrh(host, f));
    commit(surgery::kfmrh(solid_->t_, host, f));
}

FaceId EulerOperator::mfkrh(LoopId ring)
{
    require(why_not_mfkrh(ring));
    commit(surgery::mfkrh(solid_->t_, ring));
    return t().faces.last();
}

void EulerOperator::ringmv(LoopId ring, FaceId to)
{
    require(why_not_ringmv(ring, to));
    commit(surgery::ringmv(solid_->t_, ring, to));
}

void EulerOperator::move(VertexId v, const Point& point)
{
    require(why_not_move(v));
    Point& place = solid_->t_.vertices[v].point;
    if (journal_ != nullptr) journal_->points_.push_back(place);
    place = point;
    commit({.kind = OperatorKind::MOVE, .a = v.index});
}

} // namespace topology
