// Operators that make, kill and move rings: KEMR, MEKR, KFMRH, MFKRH, RINGMV.
#include "topology/halfedge/operators/surgery.h"

namespace topology::surgery {

namespace {

void leave(Tables& t, VertexId v, HalfEdgeId h, bool is_lone)
{
    if (!is_lone && t.vertices[v].half_edge == h) t.vertices[v].half_edge = staying(t, h);
}

/// The far part gets the ring; says whether the old loop pointed into it, or at the edge that goes.
bool relabel_far_part(Tables& t, HalfEdgeId h, HalfEdgeId mate, LoopId ring)
{
    const HalfEdgeId pointed = t.loops[t.loop(h)].half_edge;
    bool is_lost = pointed == h || pointed == mate;
    for (HalfEdgeId i = t.next(h); i != mate; i = t.next(i)) {
        t.half_edges[i].loop = ring;
        is_lost = is_lost || i == pointed;
    }
    return is_lost;
}

/// Both parts close where the edge was; a part that was nothing but an end of the edge becomes a lone vertex.
void part(Tables& t, HalfEdgeId h, HalfEdgeId mate, std::uint8_t was_lone)
{
    const HalfEdgeId before_h = t.prev(h), after_h = t.next(h), before_mate = t.prev(mate), after_mate = t.next(mate);
    if ((was_lone & 1U) != 0) make_lone(t, h);
    else link(t, before_h, after_mate);
    if ((was_lone & 2U) != 0) make_lone(t, mate);
    else link(t, before_mate, after_h);
    if ((was_lone & 1U) == 0) t.half_edges.kill(h);
    if ((was_lone & 2U) == 0) t.half_edges.kill(mate);
}

} // namespace

Step kemr(Tables& t, HalfEdgeId h)
{
    const HalfEdgeId mate = t.mate(h);
    const LoopId l = t.loop(h);
    const bool is_near_lone = t.next(mate) == h, is_far_lone = t.next(h) == mate;
    const HalfEdgeId near = is_near_lone ? h : t.next(mate), far = is_far_lone ? mate : t.next(h);
    const LoopId ring = t.loops.add({.half_edge = far});
    Step step{.kind = OperatorKind::KEMR, .a = h.index, .b = mate.index, .other = ring.index};
    step.old = {t.vertices[t.start(h)].half_edge.index, t.vertices[t.start(mate)].half_edge.index,
                t.loops[l].half_edge.index, t.half_edges[h].edge.index};
    step.was_lone = static_cast<std::uint8_t>((is_near_lone ? 1 : 0) + (is_far_lone ? 2 : 0));
    leave(t, t.start(h), h, is_near_lone);
    leave(t, t.start(mate), mate, is_far_lone);
    if (relabel_far_part(t, h, mate, ring)) t.loops[l].half_edge = near;
    if (is_far_lone) t.half_edges[mate].loop = ring;
    t.edges.kill(t.half_edges[h].edge);
    part(t, h, mate, step.was_lone);
    append_ring(t, t.loops[l].face, ring);
    return step;
}

namespace {

/// Restores the chain h, far part, mate, near part. The half that died still knows its neighbours; the other's are
/// found beyond them.
void rejoin(Tables& t, HalfEdgeId h, HalfEdgeId mate, std::uint8_t was_lone)
{
    const bool is_near_lone = (was_lone & 1U) != 0, is_far_lone = (was_lone & 2U) != 0;
    const HalfEdgeId before_h = is_near_lone ? mate : t.prev(h), before_mate = is_far_lone ? h : t.prev(mate);
    const HalfEdgeId after_h = is_far_lone ? mate : t.next(before_mate),
                     after_mate = is_near_lone ? h : t.next(before_h);
    link(t, before_h, h);
    link(t, h, after_h);
    link(t, before_mate, mate);
    link(t, mate, after_mate);
    if (!is_near_lone) t.half_edges.revive(h);
    if (!is_far_lone) t.half_edges.revive(mate);
}

} // namespace

void undo_kemr(Tables& t, const Step& step)
{
    const HalfEdgeId h = step.first(), mate = step.second();
    const LoopId ring{step.other}, l = t.loop(h);
    const EdgeId e{step.old[3]};
    rejoin(t, h, mate, step.was_lone);
    t.half_edges[h].edge = e;
    t.half_edges[mate].edge = e;
    relabel(t, t.next(h), t.next(mate), l);
    t.edges.revive(e);
    take_out(t, ring);
    t.loops.undo_last();
    t.vertices[t.start(h)].half_edge = HalfEdgeId{step.old[0]};
    t.vertices[t.start(mate)].half_edge = HalfEdgeId{step.old[1]};
    t.loops[l].half_edge = HalfEdgeId{step.old[2]};
}

namespace {

/// The half of the new edge that starts where `place` does; a lone vertex's half-edge becomes it.
HalfEdgeId half_before(Tables& t, HalfEdgeId place, EdgeId e)
{
    if (!t.is_lone(place)) return t.half_edges.add({t.start(place), e, t.loop(place), place, t.prev(place)});
    t.half_edges[place].edge = e;
    return place;
}

} // namespace

Step mekr(Tables& t, HalfEdgeId from, HalfEdgeId to)
{
    const LoopId l = t.loop(from), dying = t.loop(to);
    Face& face = t.faces[t.loops[l].face];
    Step step{.kind = OperatorKind::MEKR, .a = from.index, .b = to.index, .other = dying.index};
    step.was_lone = static_cast<std::uint8_t>((t.is_lone(from) ? 1 : 0) + (t.is_lone(to) ? 2 : 0));
    step.was_outer = face.outer == dying ? 1 : 0;
    if (step.was_outer != 0) face.outer = l;
    const HalfEdgeId before_from = t.prev(from), before_to = t.prev(to);
    const EdgeId e = t.edges.add({});
    const HalfEdgeId minus = half_before(t, to, e), plus = half_before(t, from, e);
    t.edges[e] = {plus, minus};
    link(t, plus, (step.was_lone & 2U) != 0 ? minus : to);
    if ((step.was_lone & 2U) == 0) link(t, before_to, minus);
    link(t, minus, (step.was_lone & 1U) != 0 ? plus : from);
    if ((step.was_lone & 1U) == 0) link(t, before_from, plus);
    relabel(t, t.next(plus), minus, l);
    t.half_edges[minus].loop = l;
    take_out(t, dying);
    t.loops.kill(dying);
    return step;
}

namespace {

/// Takes the half of the edge between `before` and h out, or makes h lone again if it was that half itself.
void close_or_lone(Tables& t, HalfEdgeId before, HalfEdgeId h, bool was_lone)
{
    if (was_lone) {
        make_lone(t, h);
    } else {
        link(t, before, h);
        t.half_edges.undo_last();
    }
}

} // namespace

void undo_mekr(Tables& t, const Step& step)
{
    const HalfEdgeId from = step.first(), to = step.second();
    const LoopId revived{step.other};
    const Edge e = t.edges[t.edges.last()];
    const HalfEdgeId before_from = t.prev(e.plus), before_to = t.prev(e.minus);
    relabel(t, t.next(e.plus), e.minus, revived);
    t.half_edges[e.minus].loop = revived;
    close_or_lone(t, before_from, from, (step.was_lone & 1U) != 0);
    close_or_lone(t, before_to, to, (step.was_lone & 2U) != 0);
    t.edges.undo_last();
    t.loops.revive(revived);
    put_back(t, revived);
    if (step.was_outer != 0) t.faces[t.loops[revived].face].outer = revived;
}

Step kfmrh(Tables& t, FaceId host, FaceId f)
{
    append_ring(t, host, t.faces[f].outer);
    t.faces.kill(f);
    return {.kind = OperatorKind::KFMRH, .a = host.index, .b = f.index};
}

void undo_kfmrh(Tables& t, const Step& step)
{
    const FaceId revived{step.b};
    const LoopId l = t.faces[revived].outer;
    take_out(t, l);
    link(t, l, l);
    t.loops[l].face = revived;
    t.faces.revive(revived);
}

Step mfkrh(Tables& t, LoopId ring)
{
    Step step{.kind = OperatorKind::MFKRH, .a = ring.index};
    step.old = {t.loops[ring].face.index, t.loops[ring].prev.index};
    take_out(t, ring);
    link(t, ring, ring);
    const FaceId f = t.faces.add({ring});
    t.loops[ring].face = f;
    step.other = f.index;
    return step;
}

void undo_mfkrh(Tables& t, const Step& step)
{
    const LoopId ring{step.a};
    t.faces.undo_last();
    insert_after(t, LoopId{step.old[1]}, ring);
    t.loops[ring].face = FaceId{step.old[0]};
}

Step ringmv(Tables& t, LoopId ring, FaceId to)
{
    Step step{.kind = OperatorKind::RINGMV, .a = ring.index, .b = to.index};
    step.old = {t.loops[ring].face.index, t.loops[ring].prev.index};
    take_out(t, ring);
    append_ring(t, to, ring);
    return step;
}

void undo_ringmv(Tables& t, const Step& step)
{
    const LoopId ring{step.a};
    take_out(t, ring);
    insert_after(t, LoopId{step.old[1]}, ring);
    t.loops[ring].face = FaceId{step.old[0]};
}

} // namespace topology::surgery
