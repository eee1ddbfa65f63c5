#include "topology/halfedge/operators/change.h"

#include <algorithm>
#include <set>
#include <utility>

namespace topology {

namespace {

/// Gathers what one step did, from the step and the tables that it left.
class Survey {
public:
    Survey(const Tables& after, const Step& step) : t_(after), step_(step) { change_.kind = step.kind; }

    Change take()
    {
        survey();
        for (const Entity& entity : touched_)
            if (is_old(entity)) change_.changed.push_back(entity);
        return std::move(change_);
    }

private:
    void survey()
    {
        switch (step_.kind) {
        case OperatorKind::MVFS: return lone_vertex(change_.created, t_.vertices[VertexId{step_.other}].half_edge);
        case OperatorKind::MVR: return lone_ring(change_.created, t_.vertices[VertexId{step_.other}].half_edge);
        case OperatorKind::KVFS:
            return lone_vertex(change_.killed, t_.loops[t_.faces[FaceId{step_.a}].outer].half_edge);
        case OperatorKind::KVR: return lone_ring(change_.killed, t_.loops[LoopId{step_.a}].half_edge);
        case OperatorKind::MEV:
        case OperatorKind::SEMV: return vertex_made();
        case OperatorKind::KEV:
        case OperatorKind::JEKV: return vertex_killed();
        case OperatorKind::MEF: return face_made();
        case OperatorKind::KEF: return face_killed();
        case OperatorKind::KEMR: return ring_made();
        case OperatorKind::MEKR: return ring_killed();
        case OperatorKind::KFMRH: return face_glued();
        case OperatorKind::MFKRH: return face_freed();
        case OperatorKind::RINGMV: return ring_moved();
        case OperatorKind::MOVE: return touch(VertexId{step_.a});
        }
    }

    void lone_ring(std::vector<Entity>& list, HalfEdgeId h)
    {
        const LoopId l = t_.loop(h);
        list.insert(list.end(), {l, h, t_.start(h)});
        beside(l);
        touch(t_.loops[l].face);
    }
    void lone_vertex(std::vector<Entity>& list, HalfEdgeId h)
    {
        list.emplace_back(t_.face(h));
        lone_ring(list, h);
    }

    void vertex_made()
    {
        const VertexId w{step_.other};
        const Edge e = edge_made();
        change_.created.emplace_back(w);
        const bool is_strut = t_.next(e.minus) == e.plus;
        touch_fan(w);
        if (step_.kind == OperatorKind::SEMV)
            change_.split.push_back({t_.half_edges[step_.first()].edge, t_.half_edges[e.plus].edge});
        else if (!is_strut) change_.split.push_back({t_.start(e.minus), w});
    }
    void vertex_killed()
    {
        const VertexId w = t_.start(step_.first()), v = t_.start(step_.second());
        edge_killed(t_.half_edges[step_.first()].edge);
        change_.killed.emplace_back(w);
        touch_fan(v);
        if (step_.kind == OperatorKind::JEKV) change_.joined.push_back({surviving_edge(), edge_of(step_.first())});
        else if (t_.next(step_.first()) != step_.second() && t_.next(step_.second()) != step_.first())
            change_.joined.push_back({v, w});
    }
    /// JEKV: the other of the two edges that met at the killed vertex.
    Entity surviving_edge() const
    {
        const HalfEdgeId after = t_.next(step_.second());
        return edge_of(after == step_.first() ? t_.prev(step_.first()) : after);
    }
    EdgeId edge_of(HalfEdgeId h) const { return t_.half_edges[h].edge; }

    void face_made()
    {
        const FaceId f{step_.other};
        const Edge e = edge_made();
        const LoopId l = t_.faces[f].outer;
        change_.created.insert(change_.created.end(), {l, f});
        touch_chain(l);
        change_.split = {{t_.face(e.plus), f}, {t_.loop(e.plus), l}};
    }
    void face_killed()
    {
        const LoopId stays = t_.loop(step_.first()), dead{step_.other};
        const FaceId f = t_.loops[stays].face, dead_face = t_.loops[dead].face;
        edge_killed(t_.half_edges[step_.first()].edge);
        change_.killed.insert(change_.killed.end(), {dead, dead_face});
        touch_chain(stays);
        for (LoopId l = t_.loops[stays].next; l != stays; l = t_.loops[l].next) touch(l);
        change_.joined = {{f, dead_face}, {stays, dead}};
    }

    void ring_made()
    {
        const LoopId ring{step_.other}, stays = t_.loop(step_.first());
        edge_killed(EdgeId{step_.old[3]});
        change_.created.emplace_back(ring);
        touch_chain(ring);
        beside(ring);
        touch(stays);
        change_.split.push_back({stays, ring});
    }
    void ring_killed()
    {
        const LoopId dead{step_.other}, stays = t_.loop(edge_made().plus);
        change_.killed.emplace_back(dead);
        touch_chain(stays);
        beside(dead);
        touch(t_.loops[dead].face);
        change_.joined.push_back({stays, dead});
    }

    void face_glued()
    {
        const FaceId host{step_.a}, dead{step_.b};
        change_.killed.emplace_back(dead);
        touch(t_.faces[dead].outer);
        beside(t_.faces[dead].outer);
        touch(host);
        change_.joined.push_back({host, dead});
    }
    void face_freed()
    {
        change_.created.emplace_back(FaceId{step_.other});
        leave_face();
        change_.split.push_back({FaceId{step_.old[0]}, FaceId{step_.other}});
    }
    void ring_moved()
    {
        leave_face();
        beside(LoopId{step_.a});
        touch(FaceId{step_.b});
    }
    void leave_face()
    {
        touch(LoopId{step_.a});
        touch(FaceId{step_.old[0]});
        touch(LoopId{step_.old[1]});
        touch(t_.loops[LoopId{step_.old[1]}].next);
    }

    Edge edge_made()
    {
        const EdgeId e = t_.edges.last();
        const Edge edge = t_.edges[e];
        change_.created.emplace_back(e);
        const bool is_minus_new = !was_lone(edge.minus), is_plus_new = !was_lone(edge.plus);
        if (is_minus_new) change_.created.emplace_back(edge.minus);
        if (is_plus_new) change_.created.emplace_back(edge.plus);
        for (const HalfEdgeId h : {edge.minus, edge.plus}) around(h);
        return edge;
    }
    void edge_killed(EdgeId e)
    {
        change_.killed.emplace_back(e);
        for (const HalfEdgeId h : {step_.first(), step_.second()}) {
            if (!was_lone(h)) change_.killed.emplace_back(h);
            around(h);
            touch(t_.next(t_.prev(h))); // KEMR links it to the neighbour of the other half
        }
    }
    bool was_lone(HalfEdgeId h) const
    {
        return ((step_.was_lone & 1U) != 0 && h == step_.first()) ||
               ((step_.was_lone & 2U) != 0 && h == step_.second());
    }

    void around(HalfEdgeId h)
    {
        for (const HalfEdgeId i : {h, t_.prev(h), t_.next(h)}) touch(i);
        touch(t_.start(h));
        touch(t_.loop(h));
    }
    void beside(LoopId l)
    {
        touch(t_.loops[l].prev);
        touch(t_.loops[l].next);
    }
    void touch_fan(VertexId v)
    {
        const HalfEdgeId first = t_.vertices[v].half_edge;
        touch(first);
        for (HalfEdgeId h = t_.next_around_vertex(first); h != first; h = t_.next_around_vertex(h)) touch(h);
    }
    void touch_chain(LoopId l)
    {
        const HalfEdgeId first = t_.loops[l].half_edge;
        touch(first);
        for (HalfEdgeId h = t_.next(first); h != first; h = t_.next(h)) touch(h);
    }
    void touch(Entity entity) { touched_.insert(entity); }

    bool is_old(const Entity& entity) const
    {
        const auto lists = [&](const std::vector<Entity>& list) {
            return std::find(list.begin(), list.end(), entity) != list.end();
        };
        return !lists(change_.created) && !lists(change_.killed);
    }

    const Tables& t_;
    const Step& step_;
    Change change_;
    std::set<Entity> touched_;
};

} // namespace

Change change(const Tables& after, const Step& step) { return Survey(after, step).take(); }

Change reversed(Change change)
{
    change.kind = inverse(change.kind);
    std::swap(change.created, change.killed);
    std::swap(change.split, change.joined);
    return change;
}

} // namespace topology
