// Operators that split and merge faces: MEF and KEF.
#include "topology/halfedge/operators/surgery.h"

namespace topology::surgery {

namespace {

struct Halves {
    EdgeId edge;
    HalfEdgeId minus, plus;
};

/// The lone vertex's half-edge becomes the new face's only one; a new one takes its place in the old loop.
Halves split_lone(Tables& t, HalfEdgeId minus, LoopId new_loop)
{
    const LoopId old_loop = t.loop(minus);
    const HalfEdgeId plus{static_cast<std::uint32_t>(t.half_edges.n_rows())};
    const EdgeId e = t.edges.add({plus, minus});
    t.half_edges.add({t.start(minus), e, old_loop, plus, plus});
    t.half_edges[minus].edge = e;
    t.half_edges[minus].loop = new_loop;
    t.loops[old_loop].half_edge = plus;
    return {e, minus, plus};
}

/// The new edge's halves, not yet in any chain: minus for the new loop, plus for the old one.
Halves add_halves(Tables& t, HalfEdgeId from, HalfEdgeId to, LoopId new_loop)
{
    const LoopId old_loop = t.loop(to);
    const HalfEdgeId minus{static_cast<std::uint32_t>(t.half_edges.n_rows())}, plus{minus.index + 1};
    const EdgeId e = t.edges.add({plus, minus});
    t.half_edges.add({t.start(to), e, new_loop, minus, minus});
    t.half_edges.add({t.start(from), e, old_loop, plus, plus});
    return {e, minus, plus};
}

/// from ... to(excluded) and the minus half become a chain of their own; the plus half bridges the gap.
Halves split_chain(Tables& t, HalfEdgeId from, HalfEdgeId to, LoopId new_loop)
{
    Loop& old_loop = t.loops[t.loop(from)];
    const HalfEdgeId before = t.prev(from), last = t.prev(to);
    bool is_moved = false;
    for (HalfEdgeId h = from; h != to; h = t.next(h)) {
        t.half_edges[h].loop = new_loop;
        is_moved = is_moved || h == old_loop.half_edge;
    }
    const Halves halves = add_halves(t, from, to, new_loop);
    if (from != to) {
        link(t, last, halves.minus);
        link(t, halves.minus, from);
    }
    link(t, before, halves.plus);
    link(t, halves.plus, to);
    if (is_moved) old_loop.half_edge = halves.plus;
    return halves;
}

} // namespace

Step mef(Tables& t, HalfEdgeId from, HalfEdgeId to)
{
    const Loop& old_loop = t.loops[t.loop(from)];
    const LoopId l{static_cast<std::uint32_t>(t.loops.n_rows())};
    const FaceId f = t.faces.add({l});
    Step step{.kind = OperatorKind::MEF, .a = from.index, .b = to.index, .other = f.index};
    step.old[0] = old_loop.half_edge.index;
    step.was_lone = t.is_lone(from) ? 1 : 0;
    const Halves halves = step.was_lone != 0 ? split_lone(t, from, l) : split_chain(t, from, to, l);
    t.loops.add({halves.minus, f, l, l});
    return step;
}

void undo_mef(Tables& t, const Step& step)
{
    const HalfEdgeId from = step.first(), to = step.second();
    const Edge e = t.edges[t.edges.last()];
    const LoopId l = t.loop(e.plus);
    if (step.was_lone != 0) {
        make_lone(t, e.minus);
        t.half_edges[e.minus].loop = l;
    } else {
        relabel(t, from, from == to ? to : e.minus, l);
        const HalfEdgeId last = t.prev(e.minus);
        link(t, t.prev(e.plus), from == to ? to : from);
        if (from != to) link(t, last, to);
        t.half_edges.undo_last();
    }
    t.half_edges.undo_last();
    t.loops[l].half_edge = HalfEdgeId{step.old[0]};
    t.edges.undo_last();
    t.loops.undo_last();
    t.faces.undo_last();
}

namespace {

/// The rings of the dying face, in their order, become the last ones of the other. The dying loop keeps its links to
/// the first and the last of them.
void migrate_rings(Tables& t, LoopId dying, FaceId to)
{
    const LoopId first = t.loops[dying].next, last = t.loops[dying].prev;
    if (first == dying) return;
    for (LoopId l = first; l != dying; l = t.loops[l].next) t.loops[l].face = to;
    const LoopId outer = t.faces[to].outer, end = t.loops[outer].prev;
    link(t, end, first);
    link(t, last, outer);
}

void return_rings(Tables& t, LoopId revived)
{
    const LoopId first = t.loops[revived].next, last = t.loops[revived].prev;
    if (first == revived) return;
    link(t, t.loops[first].prev, t.loops[last].next);
    link(t, revived, first);
    link(t, last, revived);
    const FaceId f = t.loops[revived].face;
    for (LoopId l = first; l != revived; l = t.loops[l].next) t.loops[l].face = f;
}

/// Takes the edge out between two chains, which become one.
void merge_chains(Tables& t, HalfEdgeId h, HalfEdgeId mate)
{
    const HalfEdgeId before_h = t.prev(h), after_h = t.next(h), before_mate = t.prev(mate), after_mate = t.next(mate);
    if (after_mate == mate) {
        link(t, before_h, after_h);
    } else if (after_h == h) {
        link(t, before_mate, after_mate);
    } else {
        link(t, before_h, after_mate);
        link(t, before_mate, after_h);
    }
}

void leave(Tables& t, VertexId v, HalfEdgeId h)
{
    if (t.vertices[v].half_edge == h) t.vertices[v].half_edge = staying(t, h);
}

/// Both loops are the two sides of one closed edge: what stays is a lone vertex, whose half-edge is the mate.
void merge_to_lone(Tables& t, HalfEdgeId h, HalfEdgeId mate)
{
    make_lone(t, mate);
    t.half_edges[mate].loop = t.loop(h);
    t.loops[t.loop(h)].half_edge = mate;
    t.vertices[t.start(h)].half_edge = mate;
}

void merge_loops(Tables& t, HalfEdgeId h, HalfEdgeId mate)
{
    leave(t, t.start(h), h);
    leave(t, t.start(mate), mate);
    const LoopId staying_loop = t.loop(h);
    Loop& loop = t.loops[staying_loop];
    if (loop.half_edge == h) loop.half_edge = t.next(h) == h ? t.next(mate) : t.next(h);
    relabel(t, t.next(mate), mate, staying_loop);
    merge_chains(t, h, mate);
    t.half_edges.kill(mate);
}

} // namespace

Step kef(Tables& t, HalfEdgeId h)
{
    const HalfEdgeId mate = t.mate(h);
    const LoopId staying_loop = t.loop(h), dying = t.loop(mate);
    Step step{.kind = OperatorKind::KEF, .a = h.index, .b = mate.index, .other = dying.index};
    step.old = {t.vertices[t.start(h)].half_edge.index, t.vertices[t.start(mate)].half_edge.index,
                t.loops[t.loop(h)].half_edge.index};
    step.was_lone = t.next(h) == h && t.next(mate) == mate ? 2 : 0;
    t.edges.kill(t.half_edges[h].edge);
    if (step.was_lone != 0) merge_to_lone(t, h, mate);
    else merge_loops(t, h, mate);
    t.half_edges.kill(h);
    migrate_rings(t, dying, t.loops[staying_loop].face);
    t.loops.kill(dying);
    t.faces.kill(t.loops[dying].face);
    return step;
}

void undo_kef(Tables& t, const Step& step)
{
    const HalfEdgeId h = step.first(), mate = step.second();
    const EdgeId e = t.half_edges[h].edge;
    const LoopId revived{step.other};
    t.faces.revive(t.loops[revived].face);
    t.loops.revive(revived);
    return_rings(t, revived);
    t.half_edges.revive(h);
    if (step.was_lone != 0) {
        t.half_edges[mate].edge = e;
        t.half_edges[mate].loop = revived;
    } else {
        t.half_edges.revive(mate);
        put_back(t, mate);
        put_back(t, h);
        relabel(t, t.next(mate), mate, revived);
    }
    t.edges.revive(e);
    t.vertices[t.start(h)].half_edge = HalfEdgeId{step.old[0]};
    t.vertices[t.start(mate)].half_edge = HalfEdgeId{step.old[1]};
    t.loops[t.loop(h)].half_edge = HalfEdgeId{step.old[2]};
}

} // namespace topology::surgery
