#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "topology/meshing/mesh_domain.h"
#include "topology/meshing/triangulation.h"

namespace topology {

/// How large triangles are wanted, and of what shape.
struct DelaunayOptions {
    double size = 0.0;         ///< of edges far from the boundary; what the boundary has where 0
    double growth = 0.3;       ///< of edges by the distance from smaller ones
    double min_angle = 30.0;   ///< [degrees] that is asked for, at most 33
    int n_sweeps = 4;          ///< of smoothing
    std::vector<double> sizes; ///< wanted at nodes of the domain, where above 0; empty: what their edges have
};

/// Triangles inside a domain whose boundary stays as it is: its nodes' constrained Delaunay triangulation, then a place
/// put into each triangle that is too large or has too small an angle, at its circumcentre or nearer to its shortest
/// edge; no place comes into the circle over an edge of the boundary, which would have to be split. Last all are
/// smoothed. One step at a time, for those who look on.
///
/// Accuracy  where the boundary is divided evenly no angle is below the one asked for [Chew1989]; beside corners of the
///           boundary that are sharper, and where its parts are long beside a short distance, they are
/// Source    [Ruppert1995] for refinement, [Chew1989] for fixed boundaries, [Rebay1993] for places that make
///           equilateral triangles
class DelaunayMesher {
public:
    enum class Step : std::uint8_t {
        Node,     ///< a node of the boundary stands
        Edge,     ///< an edge of the boundary is made
        Outside,  ///< triangles outside are taken away
        Point,    ///< a place inside was put in
        Smoothed, ///< all places inside were moved once
        Done
    };

    DelaunayMesher(const MeshDomain& domain, DelaunayOptions options); ///< \throws CrossingEdges

    Step next();                                                  ///< makes one step. \throws CrossingEdges
    CellMesh run(const std::function<bool()>& is_cancelled = {}); ///< all steps; what there is, if it was cancelled
    CellMesh mesh() const;

    const Triangulation& triangulation() const { return triangles_; }
    bool is_inside(Triangulation::Index triangle) const { return is_inside_[triangle]; }
    Triangulation::Index last_point() const; ///< of a step that put one in

private:
    using Index = Triangulation::Index;
    struct Suspect {
        Index triangle = 0;
        std::array<Index, 3> vertices{}; ///< as it was when it was found
    };

    void insert_node(CellNode node);
    void fix_edge(const CellEdge& edge);
    void find_inside();
    bool insert_point();
    bool is_bad(Index triangle) const;
    void suspect(Index triangle);
    bool try_at(const FlatPoint& at, Index triangle, double least);
    bool encroaches(const FlatPoint& at, const Triangulation::Cavity& cavity) const;
    FlatPoint near_shortest_edge(Index triangle, const FlatPoint& centre) const;
    void smooth();
    double worst_around(Index vertex) const;
    double limit(double size) const { return options_.size > 0.0 ? std::min(options_.size, size) : size; }

    const MeshDomain& domain_;
    DelaunayOptions options_;
    Triangulation triangles_;
    double least_chord_;          ///< of the smallest angle asked for, in a circle of radius 1, squared
    std::vector<CellEdge> edges_; ///< of the boundary
    std::vector<double> sizes_;   ///< of each vertex
    std::vector<bool> is_inside_;
    std::vector<Suspect> suspects_;
    std::size_t n_nodes_ = 0, n_edges_ = 0, n_looked_ = 0; ///< that are done
    int n_sweeps_ = 0;
    bool is_carved_ = false;
    std::size_t most_points_ = 0;
};

} // namespace topology
