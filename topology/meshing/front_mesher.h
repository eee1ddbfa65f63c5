#pragma once

#include <compare>
#include <cstddef>
#include <vector>

#include "topology/meshing/domain_triangulation.h"
#include "topology/meshing/mesher.h"

namespace topology {

/// Triangles inside a domain by an advancing front: the edges between what is meshed and what is not, at first those of
/// the boundary. Its shortest edge gets a triangle: to the place that makes it as long-legged as edges are wanted there,
/// or, where other nodes or edges of the front are too near to that, to the node that sees the edge under the largest
/// angle, c; or, where that would be too large, to the middle of its circle. When the front has closed, edges are turned and places inside smoothed.
///
///      front     p            front
///   ----+       / \       +----        p is taken where it lies in the circle through a, b and c,
///        \     /   \     /             which has no node in it, and near no other node or edge;
///         +---a-----b---+              else c
///
/// What is not meshed yet is kept as a constrained Delaunay triangulation, so that the front never crosses itself and
/// every edge has its node c: the method always ends.
///
/// Accuracy  no angle is promised; on evenly divided boundaries few are below 30 degrees
/// Source    [Lo1985] for the front, [Mavriplis1995] for the triangulation of what is not meshed
class FrontMesher : public Mesher {
public:
    /// \throws CrossingEdges  \pre the domain lives as long
    FrontMesher(const MeshDomain& domain, MesherOptions options);

    Step next() override;
    CellMesh mesh() const override;      ///< triangles behind the front
    MeshMarks marks() const override;    ///< lines: the front
    std::vector<CellEdge> front() const; ///< each with what is not meshed to its left

private:
    using Index = Triangulation::Index;
    struct FrontEdge {
        double squared = 0.0; ///< length
        Index a = 0, b = 0;
        auto operator<=>(const FrontEdge&) const = default;
    };

    void start();
    bool advance();
    void push(Index a, Index b);
    bool is_open(const FrontEdge& edge) const;
    bool put_place(const FrontEdge& edge, Index triangle);
    bool try_at(const FlatPoint& at, const FrontEdge& edge, Index triangle);
    FlatPoint ideal_place(const FrontEdge& edge) const;
    bool is_clear(const FlatPoint& at, const FrontEdge& edge, const Triangulation::Cavity& cavity) const;
    double size_at(const FlatPoint& at, const Triangulation::Cavity& cavity) const;
    void close(Index triangle, const FrontEdge& edge);
    void release();

    DomainTriangulation domain_;
    Triangulation& triangles_;
    MesherOptions options_;
    std::vector<double> sizes_;    ///< of each vertex
    std::vector<FrontEdge> front_; ///< a heap, the shortest on top; some have been passed already
    std::vector<FrontEdge> made_;  ///< edges that are fixed as long as the front advances
    std::vector<bool> is_done_;    ///< of each triangle: behind the front
    std::size_t n_of_domain_ = 0, most_points_ = 0;
    int n_sweeps_ = 0;
    bool is_closed_ = false;
    Step last_ = Step::Done;
    FrontEdge chosen_; ///< of the last step
    Index last_triangle_ = 0;
};

} // namespace topology
