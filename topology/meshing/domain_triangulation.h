#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "topology/meshing/mesher.h"
#include "topology/meshing/triangulation.h"

namespace topology {

/// The triangulation of a domain's nodes with its edges fixed, made node by node and edge by edge, and which of its
/// triangles lie inside. What every mesher of triangles starts from.
class DomainTriangulation {
public:
    using Index = Triangulation::Index;

    explicit DomainTriangulation(const MeshDomain& domain); ///< \throws CrossingEdges  \pre the domain lives as long

    /// Makes one step: a node, an edge, last what is outside. Nothing when all is made. \throws CrossingEdges
    std::optional<MeshStep> next();

    Triangulation& triangles() { return triangles_; }
    const Triangulation& triangles() const { return triangles_; }
    static Index vertex(CellNode node) { return node + Triangulation::n_frame_vertices; }
    static CellNode node(Index vertex) { return vertex - Triangulation::n_frame_vertices; }
    const std::vector<CellEdge>& edges() const { return edges_; } ///< of loops in their direction, then segments
    std::size_t n_of_loops() const { return n_of_loops_; }        ///< edges
    Index last_vertex() const { return static_cast<Index>(triangles_.n_vertices() - 1); }

    bool is_inside(Index triangle) const { return is_inside_[triangle]; }
    void add_inside() { is_inside_.resize(triangles_.n_triangles(), true); } ///< after a place was put in

    /// The size of edges that is wanted at each vertex: what the edges there have, and the options allow.
    std::vector<double> sizes(const MesherOptions& options) const;
    /// More places than any mesh of such sizes has. \param sizes  of vertices
    std::size_t most_points(const std::vector<double>& sizes, const MesherOptions& options) const;

    /// Whether smoothing makes a difference that is seen.
    bool is_smoothed() const;
    /// Moves each vertex from the first on to the middle of its neighbours, where that makes no angle around it smaller
    /// than the smallest was; then edges are turned until they are Delaunay's.
    void smooth(Index first);

    CellMesh mesh() const; ///< what is inside; before that is known all that stands
    std::vector<FlatPoint> corners(Index triangle) const;
    std::vector<std::vector<FlatPoint>> cells_around(Index vertex) const; ///< \pre none of them is at the frame
    std::array<FlatPoint, 2> last_edge() const;                           ///< \pre one is made

private:
    void insert_node(CellNode node);
    void fix_edge(const CellEdge& edge);
    void find_inside();
    bool is_at_frame(Index triangle) const;
    double worst_around(Index vertex) const;

    const MeshDomain& domain_;
    Triangulation triangles_;
    std::vector<CellEdge> edges_;
    std::vector<bool> is_inside_;
    std::size_t n_of_loops_ = 0, n_nodes_ = 0, n_edges_ = 0; ///< nodes and edges that are done
    bool is_carved_ = false;
};

} // namespace topology
