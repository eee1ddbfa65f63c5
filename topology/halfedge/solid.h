#pragma once

#include <cstddef>
#include <optional>

#include "topology/halfedge/tables.h"

namespace topology {

/// How many entities of each kind; loops count the outer ones and the rings.
struct Counts {
    std::size_t vertices = 0, edges = 0, half_edges = 0, faces = 0, loops = 0;

    friend bool operator==(const Counts&, const Counts&) = default;
};

/// A walk along links that closes: the half-edges of a loop, those that start at a vertex, the loops of a face.
template <class Id> class Circle {
public:
    using Link = Id (*)(const Tables&, Id);
    Circle(const Tables& tables, Id first, Link link) : tables_(&tables), first_(first), link_(link) {}

    class Iterator {
    public:
        Iterator(const Circle& circle, bool is_end) : circle_(circle), at_(circle.first_), has_left_(is_end) {}
        Id operator*() const { return at_; }
        Iterator& operator++()
        {
            at_ = circle_.link_(*circle_.tables_, at_);
            has_left_ = true;
            return *this;
        }
        friend bool operator==(const Iterator& a, const Iterator& b)
        {
            return a.at_ == b.at_ && a.has_left_ == b.has_left_;
        }

    private:
        Circle circle_;
        Id at_;
        bool has_left_;
    };
    Iterator begin() const { return {*this, false}; }
    Iterator end() const { return {*this, true}; }

private:
    const Tables* tables_;
    Id first_;
    Link link_;
};

/// A solid bounded by closed orientable surfaces, as half-edges: a plain value that is copied and compared row for row.
///
///   Solid --- Face --- Loop --- HalfEdge --- Vertex
///                                  |  2:1
///                                 Edge
///
/// Only EulerOperator changes it; readers of files assemble one. Its shells and their genus are not stored: shells.h
/// finds them. Positions are data that vertices carry.
///
/// Source   [Mantyla1988, ch. 9 to 11]
/// Lesson   courseware/01-euler-operators.md; the classes drawn: courseware/reference/euler-operators.md
class Solid {
public:
    bool is_empty() const { return t_.faces.n_living() == 0; }
    Counts counts() const;

    bool has(VertexId v) const { return t_.vertices.has(v); }
    bool has(HalfEdgeId h) const { return t_.half_edges.has(h); }
    bool has(EdgeId e) const { return t_.edges.has(e); }
    bool has(LoopId l) const { return t_.loops.has(l); }
    bool has(FaceId f) const { return t_.faces.has(f); }

    /// Of living entities alone; what a handle of a dead one gives is not defined.
    HalfEdgeId next(HalfEdgeId h) const { return t_.next(h); }
    HalfEdgeId prev(HalfEdgeId h) const { return t_.prev(h); }
    HalfEdgeId mate(HalfEdgeId h) const { return t_.mate(h); } ///< a lone vertex's half-edge is its own mate
    HalfEdgeId next_around_vertex(HalfEdgeId h) const
    {
        return t_.next_around_vertex(h);
    } ///< clockwise about its start, seen from outside
    VertexId start(HalfEdgeId h) const { return t_.start(h); }
    VertexId end(HalfEdgeId h) const { return t_.start(t_.next(h)); }
    LoopId loop(HalfEdgeId h) const { return t_.loop(h); }
    FaceId face(HalfEdgeId h) const { return t_.face(h); }
    std::optional<EdgeId> edge(HalfEdgeId h) const; ///< none of a lone vertex
    HalfEdgeId plus(EdgeId e) const { return t_.edges[e].plus; }
    HalfEdgeId minus(EdgeId e) const { return t_.edges[e].minus; }
    HalfEdgeId half_edge(VertexId v) const { return t_.vertices[v].half_edge; } ///< one that starts there
    HalfEdgeId half_edge(LoopId l) const { return t_.loops[l].half_edge; }      ///< one of its chain
    FaceId face(LoopId l) const { return t_.loops[l].face; }
    LoopId outer(FaceId f) const { return t_.faces[f].outer; }
    bool is_outer(LoopId l) const { return outer(face(l)) == l; }
    bool is_lone(LoopId l) const { return t_.is_lone(half_edge(l)); } ///< a lone vertex, not a chain of edges
    const Point& point(VertexId v) const { return t_.vertices[v].point; }

    const Table<VertexId, Vertex>& vertices() const { return t_.vertices; }
    const Table<HalfEdgeId, HalfEdge>& half_edges() const { return t_.half_edges; }
    const Table<EdgeId, Edge>& edges() const { return t_.edges; }
    const Table<LoopId, Loop>& loops() const { return t_.loops; }
    const Table<FaceId, Face>& faces() const { return t_.faces; }
    const Tables& tables() const { return t_; }

    Circle<HalfEdgeId> chain(LoopId l) const; ///< its half-edges, in the loop's direction
    Circle<HalfEdgeId> fan(VertexId v) const; ///< the half-edges that start there, clockwise seen from outside
    Circle<LoopId> loops(FaceId f) const;     ///< the outer one first

    void reserve(const Counts& counts); ///< room for so many, which spares copying while a large solid grows
    std::size_t bytes() const;          ///< of memory that the tables hold

    friend bool operator==(const Solid&, const Solid&) = default;

private:
    friend class EulerOperator;
    friend class Assembly;
    friend class Renumbering;
    friend class CorruptedSolid;
    Tables t_;
};

} // namespace topology
