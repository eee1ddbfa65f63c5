// How faces are split: which side is the new one, and what lies in it.
#include <algorithm>

#include "topology/planar/planar_subdivision.h"

namespace topology {

/// The two loops that a new piece makes of one: to its left the piece and then `to` ... `from`, to its right the way back
/// and then `from` ... `to`. The shorter one is walked along, the other as well where that is a sliver.
PlanarSubdivision::Sides PlanarSubdivision::sides(HalfEdgeId from, HalfEdgeId to, const Piece& piece) const
{
    const FlatPoint origin = piece.from;
    const double own = area(piece, origin);
    Sides sides{.left = own, .right = -own, .sliver = extent(piece), .is_left_shorter = false};
    HalfEdgeId i = to, j = from;
    const auto go_on = [&](HalfEdgeId& h, double& side) {
        const Piece next = this->piece(h);
        side += area(next, origin);
        sides.sliver += extent(next);
        h = solid_.next(h);
    };
    while (i != from && j != to) {
        go_on(i, sides.left);
        go_on(j, sides.right);
    }
    sides.sliver *= 4.0 * snap_;
    sides.is_left_shorter = i == from;
    if (std::abs(sides.is_left_shorter ? sides.left : sides.right) > sides.sliver) return sides;
    sides.is_other_known = true;
    while (i != from) go_on(i, sides.left);
    while (j != to) go_on(j, sides.right);
    return sides;
}

/// Whether the new face, which is always a bounded one, is that to the left of the piece.
/// \throws Tangled  neither side runs around anything
bool PlanarSubdivision::is_new_face_left(HalfEdgeId from, HalfEdgeId to, const Piece& piece) const
{
    const Sides found = sides(from, to, piece);
    const LoopId l = solid_.loop(from);
    const bool are_both_bounded = solid_.is_outer(l) && solid_.face(l) != unbounded_;
    const double shorter = found.is_left_shorter ? found.left : found.right;
    bool takes_left = found.is_left_shorter == (shorter > 0.0);
    if (found.is_other_known) takes_left = found.left > found.right;
    if (are_both_bounded) takes_left = found.is_left_shorter;
    const bool is_known = found.is_other_known || takes_left == found.is_left_shorter;
    if (is_known && (takes_left ? found.left : found.right) < -found.sliver) throw Tangled();
    return takes_left;
}

EdgeId PlanarSubdivision::split_face(HalfEdgeId from, HalfEdgeId to, const Piece& piece)
{
    EulerOperator op(solid_, journal_);
    const VertexId start = solid_.start(from);
    const NewFace made = is_new_face_left(from, to, piece) ? op.mef(to, from) : op.mef(from, to);
    set(made.edge, start, piece.part);
    move_rings(made);
    return made.edge;
}

/// Of the face that was split, those that lie in the new one.
void PlanarSubdivision::move_rings(const NewFace& made)
{
    const LoopId stays = solid_.loop(made.plus);
    const FaceId f = solid_.face(stays);
    FlatBox box;
    std::vector<HalfEdgeId> inside; // one of each: loops are named anew
    for (const LoopId l : solid_.loops(f)) {
        if (l == stays || (l == solid_.outer(f) && f != unbounded_)) continue;
        if (box.is_empty())
            for (const HalfEdgeId h : solid_.chain(made.loop)) {
                const FlatBox of_edge = curves_[part_of(h).curve].box(span(h));
                box.add(of_edge.low);
                box.add(of_edge.high);
            }
        const FlatPoint p = at(solid_.start(solid_.half_edge(l)));
        if (box.has(p) && encloses(made.loop, p)) inside.push_back(solid_.half_edge(l));
    }
    for (const HalfEdgeId h : inside) {
        if (solid_.is_outer(solid_.loop(h))) make_outer(stays);
        EulerOperator(solid_, journal_).ringmv(solid_.loop(h), made.face);
    }
}

/// Of the unbounded face: a bridge between the two loops, which leaves the ring the outer one when it is taken away.
void PlanarSubdivision::make_outer(LoopId ring)
{
    EulerOperator op(solid_, journal_);
    const HalfEdgeId from = solid_.half_edge(ring), to = solid_.half_edge(solid_.outer(solid_.face(ring)));
    const VertexId start = solid_.start(from);
    const Bridge bridge = op.mekr(from, to);
    parts_.resize(solid_.edges().n_rows());
    op.kemr(solid_.start(bridge.plus) == start ? bridge.plus : bridge.minus);
}

} // namespace topology
