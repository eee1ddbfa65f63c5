#include "topology/halfedge/check/validate.h"

#include <vector>

namespace topology {

std::string_view pattern(Invariant invariant)
{
    switch (invariant) {
    case Invariant::LinkToLiving: return "{0} is linked to {1}, which does not live";
    case Invariant::NextAndPrev: return "{0} and {1} are neighbours for one of them alone: next and prev disagree";
    case Invariant::ChainInOneLoop: return "{0} and its next, {1}, lie in different loops";
    case Invariant::EdgeOfHalf: return "{0} has {1} as a half, which does not belong to it, or twice";
    case Invariant::HalfOfEdge: return "{0} names {1} as its edge, which has other halves";
    case Invariant::LoneAlone: return "{0} has no edge, but the neighbour {1}";
    case Invariant::HalvesOpposite: return "{0} does not end where its mate {1} starts";
    case Invariant::HalfOfVertex: return "{0} names {1}, which starts elsewhere";
    case Invariant::OneFan: return "{0} starts at {1}, but turning about that vertex does not meet it";
    case Invariant::HalfOfLoop: return "{0} names {1}, which lies elsewhere";
    case Invariant::OneChain: return "{0} lies in {1}, but walking along that loop does not meet it";
    case Invariant::OuterOfFace: return "{0} names {1} as its outer loop, which lies elsewhere";
    case Invariant::LoopsOfFace: return "{0} is not where the loops of {1} are chained";
    }
    return "";
}

std::string sentence(const Breach& breach, const EntityName& name)
{
    return sentence_of(pattern(breach.invariant), breach.entities, name);
}

namespace {

using Finding = std::optional<Breach>;

Finding breach(Invariant invariant, Entity a, Entity b) { return Breach{invariant, {a, b}}; }

/// Each check may follow the links that the checks before it have passed.
class TablesInspection {
public:
    explicit TablesInspection(const Tables& tables) : t_(tables) {}

    Finding edges() const
    {
        for (const EdgeId e : t_.edges) {
            const Edge& edge = t_.edges[e];
            for (const HalfEdgeId h : {edge.plus, edge.minus}) {
                if (!t_.half_edges.has(h)) return breach(Invariant::LinkToLiving, e, h);
                if (t_.half_edges[h].edge != e) return breach(Invariant::EdgeOfHalf, e, h);
            }
            if (edge.plus == edge.minus) return breach(Invariant::EdgeOfHalf, e, edge.plus);
        }
        return std::nullopt;
    }

    Finding half_edges() const
    {
        for (const HalfEdgeId h : t_.half_edges) {
            if (auto found = dead_link(h)) return found;
            if (auto found = links(h)) return found;
        }
        return std::nullopt;
    }

    Finding vertices() const
    {
        std::size_t n_met = 0;
        for (const VertexId v : t_.vertices) {
            const HalfEdgeId first = t_.vertices[v].half_edge;
            if (!t_.half_edges.has(first)) return breach(Invariant::LinkToLiving, v, first);
            if (t_.start(first) != v) return breach(Invariant::HalfOfVertex, v, first);
            HalfEdgeId h = first;
            do {
                ++n_met;
                h = t_.next_around_vertex(h);
            } while (h != first);
        }
        return n_met == t_.half_edges.n_living() ? std::nullopt : stray_of_fan();
    }

    Finding chains() const
    {
        std::size_t n_met = 0;
        for (const LoopId l : t_.loops) {
            const HalfEdgeId first = t_.loops[l].half_edge;
            if (!t_.half_edges.has(first)) return breach(Invariant::LinkToLiving, l, first);
            if (t_.loop(first) != l) return breach(Invariant::HalfOfLoop, l, first);
            HalfEdgeId h = first;
            do {
                ++n_met;
                h = t_.next(h);
            } while (h != first);
        }
        return n_met == t_.half_edges.n_living() ? std::nullopt : stray_of_chain();
    }

    Finding loops() const
    {
        for (const LoopId l : t_.loops) {
            const Loop& loop = t_.loops[l];
            if (!t_.faces.has(loop.face)) return breach(Invariant::LinkToLiving, l, loop.face);
            for (const LoopId other : {loop.next, loop.prev})
                if (!t_.loops.has(other)) return breach(Invariant::LinkToLiving, l, other);
            const Loop& next = t_.loops[loop.next];
            if (next.prev != l || next.face != loop.face) return breach(Invariant::LoopsOfFace, loop.next, loop.face);
            if (t_.loops[loop.prev].next != l) return breach(Invariant::LoopsOfFace, loop.prev, loop.face);
        }
        return std::nullopt;
    }

    Finding faces() const
    {
        std::size_t n_met = 0;
        for (const FaceId f : t_.faces) {
            const LoopId outer = t_.faces[f].outer;
            if (!t_.loops.has(outer)) return breach(Invariant::LinkToLiving, f, outer);
            if (t_.loops[outer].face != f) return breach(Invariant::OuterOfFace, f, outer);
            LoopId l = outer;
            do {
                ++n_met;
                l = t_.loops[l].next;
            } while (l != outer);
        }
        return n_met == t_.loops.n_living() ? std::nullopt : stray_loop();
    }

private:
    Finding dead_link(HalfEdgeId h) const
    {
        const HalfEdge& half = t_.half_edges[h];
        if (!t_.vertices.has(half.start)) return breach(Invariant::LinkToLiving, h, half.start);
        if (!t_.loops.has(half.loop)) return breach(Invariant::LinkToLiving, h, half.loop);
        for (const HalfEdgeId other : {half.next, half.prev})
            if (!t_.half_edges.has(other)) return breach(Invariant::LinkToLiving, h, other);
        if (half.edge != nothing<EdgeId> && !t_.edges.has(half.edge))
            return breach(Invariant::LinkToLiving, h, half.edge);
        return std::nullopt;
    }

    Finding links(HalfEdgeId h) const
    {
        const HalfEdge& half = t_.half_edges[h];
        const HalfEdge& next = t_.half_edges[half.next];
        if (next.prev != h) return breach(Invariant::NextAndPrev, h, half.next);
        if (t_.half_edges[half.prev].next != h) return breach(Invariant::NextAndPrev, half.prev, h);
        if (next.loop != half.loop) return breach(Invariant::ChainInOneLoop, h, half.next);
        if (half.edge == nothing<EdgeId>)
            return half.next == h ? std::nullopt : breach(Invariant::LoneAlone, h, half.next);
        const Edge& edge = t_.edges[half.edge];
        if (edge.plus != h && edge.minus != h) return breach(Invariant::HalfOfEdge, h, half.edge);
        const HalfEdgeId mate = t_.mate(h);
        if (t_.start(mate) != next.start) return breach(Invariant::HalvesOpposite, h, mate);
        return std::nullopt;
    }

    Finding stray_of_fan() const
    {
        std::vector<bool> is_met(t_.half_edges.n_rows());
        for (const VertexId v : t_.vertices)
            for (HalfEdgeId h = t_.vertices[v].half_edge; !is_met[h.index]; h = t_.next_around_vertex(h))
                is_met[h.index] = true;
        for (const HalfEdgeId h : t_.half_edges)
            if (!is_met[h.index]) return breach(Invariant::OneFan, h, t_.start(h));
        return std::nullopt;
    }
    Finding stray_of_chain() const
    {
        std::vector<bool> is_met(t_.half_edges.n_rows());
        for (const LoopId l : t_.loops)
            for (HalfEdgeId h = t_.loops[l].half_edge; !is_met[h.index]; h = t_.next(h)) is_met[h.index] = true;
        for (const HalfEdgeId h : t_.half_edges)
            if (!is_met[h.index]) return breach(Invariant::OneChain, h, t_.loop(h));
        return std::nullopt;
    }
    Finding stray_loop() const
    {
        std::vector<bool> is_met(t_.loops.n_rows());
        for (const FaceId f : t_.faces)
            for (LoopId l = t_.faces[f].outer; !is_met[l.index]; l = t_.loops[l].next) is_met[l.index] = true;
        for (const LoopId l : t_.loops)
            if (!is_met[l.index]) return breach(Invariant::LoopsOfFace, l, t_.loops[l].face);
        return std::nullopt;
    }

    const Tables& t_;
};

} // namespace

std::optional<Breach> why_not_valid(const Solid& solid)
{
    const TablesInspection inspection(solid.tables());
    for (const auto check : {&TablesInspection::edges, &TablesInspection::half_edges, &TablesInspection::vertices,
                             &TablesInspection::chains, &TablesInspection::loops, &TablesInspection::faces})
        if (auto found = (inspection.*check)()) return found;
    return std::nullopt;
}

void validate(const Solid& solid)
{
    if (const auto found = why_not_valid(solid)) throw BrokenInvariant(*found);
}

} // namespace topology
