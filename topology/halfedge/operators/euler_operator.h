#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "topology/halfedge/operators/change.h"
#include "topology/halfedge/operators/journal.h"
#include "topology/halfedge/operators/refusal.h"
#include "topology/halfedge/solid.h"

namespace topology {

/// What MVFS and MVR make: a lone vertex with the half-edge and the loop that stand for it.
struct LoneVertex {
    FaceId face;
    LoopId loop;
    HalfEdgeId half_edge;
    VertexId vertex;
};
/// What MEV and SEMV make. The edge is oriented from the new vertex to the old one, as its plus half runs.
struct NewEdge {
    EdgeId edge;
    HalfEdgeId minus; ///< old vertex to new
    HalfEdgeId plus;  ///< new vertex to old
    VertexId vertex;
};
/// What MEF makes.
struct NewFace {
    EdgeId edge;
    HalfEdgeId minus; ///< closes the new loop
    HalfEdgeId plus;  ///< stays in the old face
    FaceId face;
    LoopId loop;
};
/// What MEKR makes.
struct Bridge {
    EdgeId edge;
    HalfEdgeId minus, plus;
};

/// The Euler operators: the only hand that changes a Solid.
///
/// Each keeps  V - E + F - (L - F) - 2 (S - G) = 0  and the solid sound (check/validate.h). An operator whose condition
/// fails changes nothing and throws the EulerError that its twin `why_not_...` explains. Each has an inverse, which is
/// an operator too; `undo` takes the last step back by its inverse and restores every number and every link. A
/// half-edge names a corner: the place in its loop just before it, at the vertex where it starts.
///
/// Cost     the half-edges that change their vertex or loop; no operator looks at the whole solid, but RINGMV, which
///          searches outward from both faces until they meet
/// Source   [Mantyla1988, ch. 9 and 11]
/// Lesson   courseware/01-euler-operators.md, run by examples/02_tetrahedron.cpp
class EulerOperator {
public:
    explicit EulerOperator(Solid& solid) : solid_(&solid) {}
    /// Writes the journal, which must be the one that all of the solid's steps went to.
    EulerOperator(Solid& solid, Journal& journal) : solid_(&solid), journal_(&journal) {}

    void observe(Observer& observer) { observers_.push_back(&observer); }
    const Solid& solid() const { return *solid_; }

    /// Make Vertex, Face, Shell: a point on a sphere of one face.
    ///
    ///    (nothing)   ->    ( o v )       V+1 F+1 L+1 S+1
    ///
    /// Inverse  KVFS
    LoneVertex mvfs(const Point& point);
    /// Kills the shell whose only face f holds a lone vertex and nothing else.   V-1 F-1 L-1 S-1.   Inverse MVFS
    void kvfs(FaceId f);
    std::optional<Refusal> why_not_kvfs(FaceId f) const;

    /// Make Edge, Vertex: splits a vertex.
    ///
    ///      \ | /from              \   /
    ///       \|/                    \ /
    ///        v        ->       v o--->o w     the half-edges at v from `from`, turning clockwise,
    ///       /|\                  / \          up to, not including, `to` now start at w
    ///     to |                 to                               V+1 E+1
    ///
    /// Survive  v and all its half-edges. from == to grows a strut v-w into the corner; a lone vertex's half-edge
    ///          becomes the minus half. Minus stands before `from` in its loop, plus before `to`.
    /// Inverse  KEV of the plus half
    NewEdge mev(HalfEdgeId from, HalfEdgeId to, const Point& point);
    NewEdge mev(HalfEdgeId corner, const Point& point) { return mev(corner, corner, point); } ///< a strut
    std::optional<Refusal> why_not_mev(HalfEdgeId from, HalfEdgeId to) const;
    /// Kill Edge, Vertex: the edge of h and the vertex where h starts; that vertex's other half-edges move to the end.
    ///   V-1 E-1.   Survives the vertex where h ends.   Inverse MEV
    void kev(HalfEdgeId h);
    std::optional<Refusal> why_not_kev(HalfEdgeId h) const;

    /// Split Edge, Make Vertex.
    ///
    ///        v o-------->o    ->    v o---->o---->o        V+1 E+1
    ///             h                   new   w  h
    ///
    /// Survives the edge of h, from the new vertex on.   Inverse JEKV of the plus half
    NewEdge semv(HalfEdgeId h, const Point& point);
    std::optional<Refusal> why_not_semv(HalfEdgeId h) const;
    /// Join Edges, Kill Vertex: as KEV of h, where exactly two edges meet at its start.   V-1 E-1.   Inverse SEMV
    void jekv(HalfEdgeId h);
    std::optional<Refusal> why_not_jekv(HalfEdgeId h) const;

    /// Make Vertex, Ring: a lone vertex inside f, as MEV and then KEMR would make it.   V+1 L+1.   Inverse KVR
    LoneVertex mvr(FaceId f, const Point& point);
    std::optional<Refusal> why_not_mvr(FaceId f) const;
    void kvr(LoopId ring); ///< V-1 L-1
    std::optional<Refusal> why_not_kvr(LoopId ring) const;

    /// Make Edge, Face: splits a loop and its face.
    ///
    ///      o-------->o             o-------->o
    ///      ^         |             ^ new   / |      from ... up to, not including, to
    ///      |    f    |     ->      |     /   |      bounds the new face;            E+1 F+1 L+1
    ///  from|         v         from|   /  f  v      plus (from's start to to's start) stays in f
    ///      o<--------o             o<--------o
    ///             to                     to
    ///
    /// Survive  f, its loop and its rings, all of which stay (RINGMV moves them). from == to makes a face of one closed
    ///          edge; a lone vertex's half-edge becomes the minus half.
    /// Inverse  KEF of the plus half
    NewFace mef(HalfEdgeId from, HalfEdgeId to);
    std::optional<Refusal> why_not_mef(HalfEdgeId from, HalfEdgeId to) const;
    /// Kill Edge, Face: the edge of h and the face on its other side, whose other loops become rings of h's face.
    ///   E-1 F-1 L-1.   Survives the face of h.   Inverse MEF, and RINGMV where there were rings
    void kef(HalfEdgeId h);
    std::optional<Refusal> why_not_kef(HalfEdgeId h) const;

    /// Kill Edge, Make Ring: splits a loop that runs along both sides of the edge of h.
    ///
    ///      o---------o          o---------o
    ///      |  o-o    |          |  o-o    |
    ///      |  | |h<--|    ->    |  | |    |     E-1 L+1     the part at h's start keeps the loop,
    ///      |  o-o    |          |  o-o    |                 that at its end is the new ring
    ///      o---------o          o---------o
    ///
    /// A part that was nothing but an end of the edge becomes a lone vertex.   Inverse  MEKR
    LoopId kemr(HalfEdgeId h);
    std::optional<Refusal> why_not_kemr(HalfEdgeId h) const;
    /// Make Edge, Kill Ring: an edge between the corners of two loops of one face.   E+1 L-1
    ///   Survives the loop of `from`, as the outer one if either was.   Inverse KEMR of the plus half
    Bridge mekr(HalfEdgeId from, HalfEdgeId to);
    std::optional<Refusal> why_not_mekr(HalfEdgeId from, HalfEdgeId to) const;

    /// Kill Face, Make Ring, Hole: f, which has one loop, becomes a ring of `host`, as if the two were glued.
    ///   F-1 G+1 where both lie in one shell: a handle;   F-1 S-1 where they lie in two: these are joined.
    ///   Inverse MFKRH
    void kfmrh(FaceId host, FaceId f);
    std::optional<Refusal> why_not_kfmrh(FaceId host, FaceId f) const;
    /// Make Face, Kill Ring, Hole: the ring bounds a face of its own.
    ///   F+1 G-1, or F+1 S+1 where nothing else connected the two parts.   Inverse KFMRH
    FaceId mfkrh(LoopId ring);
    std::optional<Refusal> why_not_mfkrh(LoopId ring) const;

    /// Moves a ring to another face of its shell, which needs it after MEF. No count changes.   Inverse RINGMV
    void ringmv(LoopId ring, FaceId to);
    std::optional<Refusal> why_not_ringmv(LoopId ring, FaceId to) const;

    /// Geometry only.   Inverse itself
    void move(VertexId v, const Point& point);
    std::optional<Refusal> why_not_move(VertexId v) const;

    /// By the inverse of the last step, or the step again. Numbers and links are as they were, bit for bit.
    /// \pre the journal has a step to undo, or one that was undone
    void undo();
    void redo();

private:
    void commit(const Step& step);
    void undo_step(const Step& step);
    void tell(const Change& change) const;
    const Tables& t() const { return solid_->t_; }

    Solid* solid_;
    Journal* journal_ = nullptr;
    std::vector<Observer*> observers_;
};

} // namespace topology
