#include <array>
#include <stdexcept>
#include <utility>

#include "topology/halfedge/operators/euler_operator.h"
#include "topology/halfedge/operators/surgery.h"

namespace topology {

namespace {

using Undo = void (*)(Tables&, const Step&);

/// In the order of OperatorKind. MOVE is undone with the journal's points.
constexpr std::array<Undo, 15> undo_of{
    surgery::undo_mvfs, surgery::undo_kvfs, surgery::undo_mev,   surgery::undo_kev,   surgery::undo_semv,
    surgery::undo_kev,  surgery::undo_mvr,  surgery::undo_kvr,   surgery::undo_mef,   surgery::undo_kef,
    surgery::undo_kemr, surgery::undo_mekr, surgery::undo_kfmrh, surgery::undo_mfkrh, surgery::undo_ringmv};

bool makes_vertex(OperatorKind kind)
{
    return kind == OperatorKind::MVFS || kind == OperatorKind::MEV || kind == OperatorKind::SEMV ||
           kind == OperatorKind::MVR;
}

Point taken_last(std::vector<Point>& points)
{
    const Point point = points.back();
    points.pop_back();
    return point;
}

/// The operator again, on tables that are as it once found them: it makes the same rows.
Step again(Tables& t, const Step& step, const Point& point)
{
    const HalfEdgeId first = step.first(), second = step.second();
    switch (step.kind) {
    case OperatorKind::MVFS: return surgery::mvfs(t, point);
    case OperatorKind::KVFS: return surgery::kvfs(t, FaceId{step.a});
    case OperatorKind::MEV: return surgery::mev(t, first, second, point);
    case OperatorKind::KEV:
    case OperatorKind::JEKV: return surgery::kev(t, first, step.kind);
    case OperatorKind::SEMV: return surgery::semv(t, first, point);
    case OperatorKind::MVR: return surgery::mvr(t, FaceId{step.a}, point);
    case OperatorKind::KVR: return surgery::kvr(t, LoopId{step.a});
    case OperatorKind::MEF: return surgery::mef(t, first, second);
    case OperatorKind::KEF: return surgery::kef(t, first);
    case OperatorKind::KEMR: return surgery::kemr(t, first);
    case OperatorKind::MEKR: return surgery::mekr(t, first, second);
    case OperatorKind::KFMRH: return surgery::kfmrh(t, FaceId{step.a}, FaceId{step.b});
    case OperatorKind::MFKRH: return surgery::mfkrh(t, LoopId{step.a});
    case OperatorKind::RINGMV: return surgery::ringmv(t, LoopId{step.a}, FaceId{step.b});
    case OperatorKind::MOVE: break;
    }
    t.vertices[VertexId{step.a}].point = point;
    return step;
}

} // namespace

void EulerOperator::undo()
{
    if (journal_ == nullptr || journal_->n_done() == 0) throw std::logic_error("there is no step to undo");
    const Step& step = journal_->steps_[--journal_->n_done_];
    if (observers_.empty()) return undo_step(step);
    const Change undone = reversed(change(t(), step));
    undo_step(step);
    tell(undone);
}

void EulerOperator::undo_step(const Step& step)
{
    Tables& tables = solid_->t_;
    if (step.kind == OperatorKind::MOVE) {
        const Point before = taken_last(journal_->points_);
        journal_->undone_points_.push_back(std::exchange(tables.vertices[VertexId{step.a}].point, before));
        return;
    }
    if (makes_vertex(step.kind)) journal_->undone_points_.push_back(tables.vertices[VertexId{step.other}].point);
    undo_of[static_cast<std::size_t>(step.kind)](tables, step);
}

void EulerOperator::redo()
{
    if (journal_ == nullptr || journal_->n_undone() == 0) throw std::logic_error("there is no step to redo");
    const Step step = journal_->steps_[journal_->n_done_++];
    Point point;
    if (makes_vertex(step.kind) || step.kind == OperatorKind::MOVE) point = taken_last(journal_->undone_points_);
    if (step.kind == OperatorKind::MOVE) journal_->points_.push_back(t().vertices[VertexId{step.a}].point);
    again(solid_->t_, step, point);
    if (!observers_.empty()) tell(change(t(), step));
}

} // namespace topology
