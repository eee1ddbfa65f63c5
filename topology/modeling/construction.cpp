#include "topology/modeling/construction.h"

namespace topology {

namespace {

/// Takes a solid apart by operators whose inverses put it together again.
class Reduction {
public:
    explicit Reduction(const Solid& original) : solid(original), op_(solid, journal)
    {
        for (const FaceId f : original.faces()) kill_rings(f);
        for (const FaceId f : original.faces())
            if (solid.has(f)) kill_shell(f);
    }

    Solid solid;
    Journal journal;

private:
    void kill_rings(FaceId f)
    {
        const LoopId outer = solid.outer(f);
        while (solid.tables().loops[outer].next != outer)
            op_.mekr(solid.half_edge(outer), solid.half_edge(solid.tables().loops[outer].next));
    }

    void kill_shell(FaceId f)
    {
        f = merge_faces(f);
        peel(f);
        merge_vertices(solid.start(solid.half_edge(solid.outer(f))));
        while (!solid.is_lone(solid.outer(f))) f = kill_handle(f);
        op_.kvfs(f);
    }

    /// MEF makes a face of one closed edge only as the new one, so that such a face must be the one that dies.
    /// \returns the face that stays
    FaceId kef(HalfEdgeId h)
    {
        const HalfEdgeId mate = solid.mate(h);
        if (solid.next(h) == h && solid.next(mate) != mate) h = mate;
        const FaceId stays = solid.face(h);
        op_.kef(h);
        return stays;
    }

    /// Outward from f, so that each face's half-edges change their loop once.
    FaceId merge_faces(FaceId f)
    {
        std::vector<HalfEdgeId> open;
        open_chain(solid.outer(f), open);
        while (!open.empty()) {
            const HalfEdgeId h = open.back();
            open.pop_back();
            if (!solid.has(h)) continue;
            const HalfEdgeId mate = solid.mate(h);
            if (solid.face(mate) == solid.face(h)) continue;
            open_chain(solid.loop(mate), open);
            f = kef(h);
        }
        return f;
    }
    void open_chain(LoopId l, std::vector<HalfEdgeId>& open) const
    {
        for (const HalfEdgeId h : solid.chain(l)) open.push_back(h);
    }

    /// Kills the struts, from their tips on: all of a shell without handles, whose edges are now a tree.
    void peel(FaceId f)
    {
        std::vector<HalfEdgeId> open;
        open_chain(solid.outer(f), open);
        while (!open.empty()) {
            const HalfEdgeId h = open.back();
            open.pop_back();
            if (!solid.has(h) || !solid.edge(h) || solid.next_around_vertex(h) != h) continue;
            const VertexId v = solid.end(h);
            op_.kev(h);
            open.push_back(solid.half_edge(v));
        }
    }

    /// Every other vertex goes into v. At least two edges meet at each, so that none is the tip of a strut, which MEV
    /// would make as the new vertex only.
    void merge_vertices(VertexId v)
    {
        std::vector<HalfEdgeId> open;
        open_fan(v, open);
        while (!open.empty()) {
            const HalfEdgeId h = open.back();
            open.pop_back();
            if (!solid.has(h) || !solid.edge(h) || solid.start(h) == solid.end(h)) continue;
            open_fan(solid.end(h), open);
            op_.kev(solid.mate(h));
        }
    }
    void open_fan(VertexId v, std::vector<HalfEdgeId>& open) const
    {
        for (const HalfEdgeId h : solid.fan(v)) open.push_back(h);
    }

    FaceId kill_handle(FaceId f)
    {
        const FaceId half = op_.mfkrh(op_.kemr(solid.half_edge(solid.outer(f))));
        for (const HalfEdgeId h : solid.chain(solid.outer(half)))
            if (solid.face(solid.mate(h)) != half) return kef(solid.mate(h));
        return f; // not reached: every edge starts at the one vertex, so that the two halves share one
    }

    EulerOperator op_;
};

/// Does the inverse of each step of a reduction, the last one first, on a new solid.
class Rebuilding {
public:
    explicit Rebuilding(Reduction& reduction)
        : old_(reduction.solid), back_(reduction.solid, reduction.journal), op_(done.solid, done.journal)
    {
        half_edges_.resize(old_.half_edges().n_rows());
        vertices_.resize(old_.vertices().n_rows());
        faces_.resize(old_.faces().n_rows());
        while (reduction.journal.n_done() != 0) invert(reduction.journal[reduction.journal.n_done() - 1]);
    }

    Construction done;

private:
    void invert(const Step& step)
    {
        const HalfEdgeId bridge = step.kind == OperatorKind::MEKR ? old_.plus(old_.edges().last()) : HalfEdgeId{};
        back_.undo();
        const HalfEdgeId h = step.first(), mate = step.second();
        switch (step.kind) {
        case OperatorKind::KVFS: return make_shell(FaceId{step.a});
        case OperatorKind::KEV: return make_vertex(h, mate);
        case OperatorKind::KEF: return make_face(h, mate);
        case OperatorKind::KEMR: return make_bridge(h, mate);
        case OperatorKind::MFKRH: return op_.kfmrh(now(FaceId{step.old[0]}), now(FaceId{step.other}));
        default: op_.kemr(now(bridge));
        }
    }

    void make_shell(FaceId f)
    {
        const HalfEdgeId h = old_.half_edge(old_.outer(f));
        const LoneVertex made = op_.mvfs(old_.point(old_.start(h)));
        name(f, made.face);
        name(old_.start(h), made.vertex);
        half_edges_[h.index] = made.half_edge;
    }
    void make_vertex(HalfEdgeId h, HalfEdgeId mate)
    {
        const bool is_strut = old_.next(mate) == h, is_whole = is_strut && old_.next(h) == mate;
        const HalfEdgeId to = is_whole ? mate : old_.next(h), from = is_strut ? to : old_.next(mate);
        const NewEdge made = op_.mev(now(from), now(to), old_.point(old_.start(h)));
        half_edges_[h.index] = made.plus;
        half_edges_[mate.index] = made.minus;
        name(old_.start(h), made.vertex);
    }
    void make_face(HalfEdgeId h, HalfEdgeId mate)
    {
        const bool is_closed = old_.next(mate) == mate, is_whole = is_closed && old_.next(h) == h;
        const HalfEdgeId to = is_whole ? mate : old_.next(h), from = is_closed ? to : old_.next(mate);
        const NewFace made = op_.mef(now(from), now(to));
        half_edges_[h.index] = made.plus;
        half_edges_[mate.index] = made.minus;
        name(old_.face(mate), made.face);
    }
    void make_bridge(HalfEdgeId h, HalfEdgeId mate)
    {
        const Bridge made = op_.mekr(now(old_.next(mate)), now(old_.next(h)));
        half_edges_[h.index] = made.plus;
        half_edges_[mate.index] = made.minus;
    }

    HalfEdgeId now(HalfEdgeId h) const { return half_edges_[h.index]; }
    FaceId now(FaceId f) const { return faces_[f.index]; }
    void name(FaceId original, FaceId f)
    {
        faces_[original.index] = f;
        done.face_of.push_back(original);
    }
    void name(VertexId original, VertexId v)
    {
        vertices_[original.index] = v;
        done.vertex_of.push_back(original);
    }

    const Solid& old_;
    EulerOperator back_, op_;
    std::vector<HalfEdgeId> half_edges_; // by old index
    std::vector<VertexId> vertices_;
    std::vector<FaceId> faces_;
};

} // namespace

Construction construction(const Solid& original)
{
    const std::size_t n_faces = original.faces().n_rows();
    Reduction reduction(original);
    Construction done = Rebuilding(reduction).done;
    for (FaceId& f : done.face_of)
        if (f.index >= n_faces) f = nothing<FaceId>;
    return done;
}

} // namespace topology
