// Operators that make and kill vertices: MVFS, MEV, SEMV, MVR and their inverses.
#include "topology/halfedge/operators/surgery.h"

namespace topology::surgery {

Step mvfs(Tables& t, const Point& point)
{
    const HalfEdgeId h{static_cast<std::uint32_t>(t.half_edges.n_rows())};
    const LoopId l{static_cast<std::uint32_t>(t.loops.n_rows())};
    const VertexId v = t.vertices.add({h, point});
    const FaceId f = t.faces.add({l});
    t.half_edges.add({v, nothing<EdgeId>, l, h, h});
    t.loops.add({h, f, l, l});
    return {.kind = OperatorKind::MVFS, .other = v.index};
}

void undo_mvfs(Tables& t, const Step& /*step*/)
{
    t.vertices.undo_last();
    t.half_edges.undo_last();
    t.loops.undo_last();
    t.faces.undo_last();
}

Step kvfs(Tables& t, FaceId f)
{
    const LoopId l = t.faces[f].outer;
    const HalfEdgeId h = t.loops[l].half_edge;
    t.vertices.kill(t.start(h));
    t.half_edges.kill(h);
    t.loops.kill(l);
    t.faces.kill(f);
    return {.kind = OperatorKind::KVFS, .a = f.index};
}

void undo_kvfs(Tables& t, const Step& step)
{
    const FaceId f{step.a};
    const LoopId l = t.faces[f].outer;
    const HalfEdgeId h = t.loops[l].half_edge;
    t.faces.revive(f);
    t.loops.revive(l);
    t.half_edges.revive(h);
    t.vertices.revive(t.start(h));
}

Step mvr(Tables& t, FaceId f, const Point& point)
{
    const HalfEdgeId h{static_cast<std::uint32_t>(t.half_edges.n_rows())};
    const VertexId v = t.vertices.add({h, point});
    const LoopId l = t.loops.add({.half_edge = h});
    t.half_edges.add({v, nothing<EdgeId>, l, h, h});
    append_ring(t, f, l);
    return {.kind = OperatorKind::MVR, .a = f.index, .other = v.index};
}

void undo_mvr(Tables& t, const Step& /*step*/)
{
    take_out(t, t.loops.last());
    t.loops.undo_last();
    t.half_edges.undo_last();
    t.vertices.undo_last();
}

Step kvr(Tables& t, LoopId l)
{
    const HalfEdgeId h = t.loops[l].half_edge;
    take_out(t, l);
    t.loops.kill(l);
    t.half_edges.kill(h);
    t.vertices.kill(t.start(h));
    return {.kind = OperatorKind::KVR, .a = l.index};
}

void undo_kvr(Tables& t, const Step& step)
{
    const LoopId l{step.a};
    const HalfEdgeId h = t.loops[l].half_edge;
    t.vertices.revive(t.start(h));
    t.half_edges.revive(h);
    t.loops.revive(l);
    put_back(t, l);
}

namespace {

/// The lone vertex's half-edge becomes the minus half of its first edge.
EdgeId grow_from_lone(Tables& t, HalfEdgeId minus, VertexId w)
{
    const LoopId l = t.loop(minus);
    const HalfEdgeId plus{static_cast<std::uint32_t>(t.half_edges.n_rows())};
    const EdgeId e = t.edges.add({plus, minus});
    t.half_edges.add({w, e, l, minus, minus});
    t.half_edges[minus].edge = e;
    link(t, minus, plus);
    link(t, plus, minus);
    t.loops[l].half_edge = plus;
    return e;
}

/// A new edge whose minus half starts at v, before `minus_place`, and whose plus half starts at w, before `plus_place`.
EdgeId grow(Tables& t, HalfEdgeId minus_place, HalfEdgeId plus_place, VertexId v, VertexId w)
{
    const HalfEdgeId minus{static_cast<std::uint32_t>(t.half_edges.n_rows())}, plus{minus.index + 1};
    const EdgeId e = t.edges.add({plus, minus});
    t.half_edges.add({v, e, t.loop(minus_place), minus_place, t.prev(minus_place)});
    t.half_edges.add({w, e, t.loop(plus_place), plus_place, plus_place});
    put_back(t, minus);
    insert_before(t, plus, plus_place);
    return e;
}

/// The two halves of the newest edge leave their chains and the table.
void shrink(Tables& t)
{
    const Edge e = t.edges[t.edges.last()];
    take_out(t, e.plus);
    take_out(t, e.minus);
    t.half_edges.undo_last();
    t.half_edges.undo_last();
}

} // namespace

Step mev(Tables& t, HalfEdgeId from, HalfEdgeId to, const Point& point)
{
    const VertexId v = t.start(from);
    const VertexId w = t.vertices.add({nothing<HalfEdgeId>, point});
    Step step{.kind = OperatorKind::MEV, .a = from.index, .b = to.index, .other = w.index};
    step.old[0] = t.vertices[v].half_edge.index;
    step.was_lone = t.is_lone(from) ? 1 : 0;
    restart(t, from, to, w);
    const EdgeId e = step.was_lone != 0 ? grow_from_lone(t, from, w) : grow(t, from, to, v, w);
    t.vertices[w].half_edge = t.edges[e].plus;
    t.vertices[v].half_edge = to;
    return step;
}

void undo_mev(Tables& t, const Step& step)
{
    const HalfEdgeId minus = t.edges[t.edges.last()].minus;
    const VertexId v = t.start(minus);
    if (step.was_lone != 0) {
        make_lone(t, minus);
        t.loops[t.loop(minus)].half_edge = minus;
        t.half_edges.undo_last();
    } else {
        shrink(t);
        restart(t, step.first(), step.second(), v);
    }
    t.vertices[v].half_edge = HalfEdgeId{step.old[0]};
    t.edges.undo_last();
    t.vertices.undo_last();
}

Step semv(Tables& t, HalfEdgeId h, const Point& point)
{
    const VertexId v = t.start(h);
    const VertexId w = t.vertices.add({nothing<HalfEdgeId>, point});
    Step step{.kind = OperatorKind::SEMV, .a = h.index, .other = w.index};
    step.old[0] = t.vertices[v].half_edge.index;
    const HalfEdgeId mate = t.mate(h);
    t.half_edges[h].start = w;
    // At the tip of a strut h follows its own mate: there the new halves stand between the two, plus first.
    const bool is_tip = t.next(mate) == h;
    const EdgeId e = grow(t, h, is_tip ? h : t.next(mate), v, w);
    const Edge edge = t.edges[e];
    if (is_tip) {
        link(t, mate, edge.plus);
        link(t, edge.plus, edge.minus);
        link(t, edge.minus, h);
    }
    t.vertices[w].half_edge = edge.plus;
    t.vertices[v].half_edge = t.next(edge.plus);
    return step;
}

void undo_semv(Tables& t, const Step& step)
{
    const VertexId v = t.start(t.edges[t.edges.last()].minus);
    shrink(t);
    t.half_edges[step.first()].start = v;
    t.vertices[v].half_edge = HalfEdgeId{step.old[0]};
    t.edges.undo_last();
    t.vertices.undo_last();
}

namespace {

/// The half-edge that follows in the same loop when h and its mate are gone.
HalfEdgeId following(const Tables& t, HalfEdgeId h, HalfEdgeId mate)
{
    return t.next(h) == mate ? t.next(mate) : t.next(h);
}

void cut_off(Tables& t, HalfEdgeId h, HalfEdgeId mate)
{
    const VertexId v = t.start(mate);
    Vertex& vertex = t.vertices[v];
    if (vertex.half_edge == mate) vertex.half_edge = following(t, h, mate);
    Loop& one = t.loops[t.loop(h)];
    if (one.half_edge == h || one.half_edge == mate) one.half_edge = following(t, h, mate);
    Loop& other = t.loops[t.loop(mate)];
    if (other.half_edge == mate) other.half_edge = following(t, mate, h);
    take_out(t, h);
    take_out(t, mate);
    t.half_edges.kill(mate);
}

} // namespace

Step kev(Tables& t, HalfEdgeId h, OperatorKind kind)
{
    const HalfEdgeId mate = t.mate(h);
    const VertexId w = t.start(h), v = t.start(mate);
    Step step{.kind = kind, .a = h.index, .b = mate.index};
    step.old = {t.vertices[v].half_edge.index, t.loops[t.loop(h)].half_edge.index,
                t.loops[t.loop(mate)].half_edge.index};
    step.was_lone = t.next(h) == mate && t.next(mate) == h ? 2 : 0;
    t.vertices.kill(w);
    t.edges.kill(t.half_edges[h].edge);
    restart(t, t.next(mate), h, v);
    if (step.was_lone != 0) {
        make_lone(t, mate);
        t.loops[t.loop(mate)].half_edge = mate;
    } else {
        cut_off(t, h, mate);
    }
    t.half_edges.kill(h);
    return step;
}

void undo_kev(Tables& t, const Step& step)
{
    const HalfEdgeId h = step.first(), mate = step.second();
    const EdgeId e = t.half_edges[h].edge;
    const VertexId w = t.start(h), v = t.start(mate);
    t.half_edges.revive(h);
    if (step.was_lone != 0) {
        t.half_edges[mate].edge = e;
        link(t, h, mate);
        link(t, mate, h);
    } else {
        t.half_edges.revive(mate);
        put_back(t, mate);
        put_back(t, h);
    }
    restart(t, t.next(mate), h, w);
    t.edges.revive(e);
    t.vertices.revive(w);
    t.vertices[v].half_edge = HalfEdgeId{step.old[0]};
    t.loops[t.loop(h)].half_edge = HalfEdgeId{step.old[1]};
    t.loops[t.loop(mate)].half_edge = HalfEdgeId{step.old[2]};
}

} // namespace topology::surgery
