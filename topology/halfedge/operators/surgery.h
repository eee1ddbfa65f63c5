#pragma once

#include "topology/halfedge/operators/step.h"
#include "topology/halfedge/tables.h"

/// The operators as they change the tables, without asking whether they may. Each returns the step that its `undo`
/// takes back, row for row and link for link; `undo` must meet the tables as the step left them.
/// What they mean stands in euler_operator.h.
namespace topology::surgery {

Step mvfs(Tables& t, const Point& point);
Step kvfs(Tables& t, FaceId f);
Step mev(Tables& t, HalfEdgeId from, HalfEdgeId to, const Point& point);
Step kev(Tables& t, HalfEdgeId h, OperatorKind kind); ///< KEV or JEKV
Step semv(Tables& t, HalfEdgeId h, const Point& point);
Step mvr(Tables& t, FaceId f, const Point& point);
Step kvr(Tables& t, LoopId l);
Step mef(Tables& t, HalfEdgeId from, HalfEdgeId to);
Step kef(Tables& t, HalfEdgeId h);
Step kemr(Tables& t, HalfEdgeId h);
Step mekr(Tables& t, HalfEdgeId from, HalfEdgeId to);
Step kfmrh(Tables& t, FaceId host, FaceId f);
Step mfkrh(Tables& t, LoopId ring);
Step ringmv(Tables& t, LoopId ring, FaceId to);

void undo_mvfs(Tables& t, const Step& step);
void undo_kvfs(Tables& t, const Step& step);
void undo_mev(Tables& t, const Step& step);
void undo_kev(Tables& t, const Step& step);
void undo_semv(Tables& t, const Step& step);
void undo_mvr(Tables& t, const Step& step);
void undo_kvr(Tables& t, const Step& step);
void undo_mef(Tables& t, const Step& step);
void undo_kef(Tables& t, const Step& step);
void undo_kemr(Tables& t, const Step& step);
void undo_mekr(Tables& t, const Step& step);
void undo_kfmrh(Tables& t, const Step& step);
void undo_mfkrh(Tables& t, const Step& step);
void undo_ringmv(Tables& t, const Step& step);

/// Chains of half-edges and of a face's loops are circles of links. What is taken out keeps its own links, so that
/// `put_back`, in the opposite order, restores the circle.
inline void link(Tables& t, HalfEdgeId a, HalfEdgeId b)
{
    t.half_edges[a].next = b;
    t.half_edges[b].prev = a;
}
inline void insert_before(Tables& t, HalfEdgeId h, HalfEdgeId place)
{
    link(t, t.prev(place), h);
    link(t, h, place);
}
inline void take_out(Tables& t, HalfEdgeId h) { link(t, t.prev(h), t.next(h)); }
inline void put_back(Tables& t, HalfEdgeId h)
{
    link(t, t.prev(h), h);
    link(t, h, t.next(h));
}
inline void link(Tables& t, LoopId a, LoopId b)
{
    t.loops[a].next = b;
    t.loops[b].prev = a;
}
inline void take_out(Tables& t, LoopId l) { link(t, t.loops[l].prev, t.loops[l].next); }
inline void put_back(Tables& t, LoopId l)
{
    link(t, t.loops[l].prev, l);
    link(t, l, t.loops[l].next);
}
inline void insert_after(Tables& t, LoopId place, LoopId l)
{
    const LoopId after = t.loops[place].next;
    link(t, place, l);
    link(t, l, after);
}
/// As the last of the face's rings.
inline void append_ring(Tables& t, FaceId f, LoopId l)
{
    t.loops[l].face = f;
    insert_after(t, t.loops[t.faces[f].outer].prev, l);
}

/// Makes h the half-edge of a lone vertex, all of its loop.
inline void make_lone(Tables& t, HalfEdgeId h)
{
    t.half_edges[h].edge = nothing<EdgeId>;
    link(t, h, h);
}

/// Half-edges from `from` up to, not including, `to` get the loop.
inline void relabel(Tables& t, HalfEdgeId from, HalfEdgeId to, LoopId loop)
{
    for (HalfEdgeId h = from; h != to; h = t.next(h)) t.half_edges[h].loop = loop;
}
/// Half-edges that start at one vertex, from `from` turning up to, not including, `to`, get another start.
inline void restart(Tables& t, HalfEdgeId from, HalfEdgeId to, VertexId start)
{
    for (HalfEdgeId h = from; h != to; h = t.next_around_vertex(h)) t.half_edges[h].start = start;
}

/// Where a vertex must not point at a half-edge whose edge is about to go: the next one of its half-edges that stays.
inline HalfEdgeId staying(const Tables& t, HalfEdgeId h)
{
    const EdgeId dying = t.half_edges[h].edge;
    HalfEdgeId other = t.next_around_vertex(h);
    while (other != h && t.half_edges[other].edge == dying) other = t.next_around_vertex(other);
    return other;
}

} // namespace topology::surgery
