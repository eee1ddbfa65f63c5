#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "topology/meshing/domain_triangulation.h"
#include "topology/meshing/mesher.h"
#include "topology/meshing/triangulation.h"

namespace topology {

/// Triangles inside a domain whose boundary stays as it is: its nodes' constrained Delaunay triangulation, then a place
/// put into each triangle that is too large or has too small an angle, at its circumcentre or nearer to its shortest
/// edge; no place comes into the circle over an edge of the boundary, which would have to be split. Last all are
/// smoothed. One step at a time, for those who look on.
///
/// Accuracy  where the boundary is divided evenly no angle is below the one asked for [Chew1989]; beside corners of the
///           boundary that are sharper, and where its parts are long beside a short distance, they are
/// Source    [Ruppert1995] for refinement, [Chew1989] for fixed boundaries, [Rebay1993] for places that make
///           equilateral triangles
class DelaunayMesher : public Mesher {
public:
    /// \throws CrossingEdges  \pre the domain lives as long
    DelaunayMesher(const MeshDomain& domain, MesherOptions options);

    Step next() override;
    CellMesh mesh() const override { return domain_.mesh(); }
    MeshMarks marks() const override;

    const Triangulation& triangulation() const { return domain_.triangles(); }
    bool is_inside(Triangulation::Index triangle) const { return domain_.is_inside(triangle); }
    Triangulation::Index last_point() const { return domain_.last_vertex(); } ///< of a step that put one in

private:
    using Index = Triangulation::Index;
    struct Suspect {
        Index triangle = 0;
        std::array<Index, 3> vertices{}; ///< as it was when it was found
    };

    void suspect_all();
    bool insert_point();
    bool is_bad(Index triangle) const;
    void suspect(Index triangle);
    bool try_at(const FlatPoint& at, Index triangle, double least);
    bool encroaches(const FlatPoint& at, const Triangulation::Cavity& cavity) const;
    FlatPoint near_shortest_edge(Index triangle, const FlatPoint& centre) const;

    DomainTriangulation domain_;
    Triangulation& triangles_;
    MesherOptions options_;
    double least_chord_;        ///< of the smallest angle asked for, in a circle of radius 1, squared
    std::vector<double> sizes_; ///< of each vertex
    std::vector<Suspect> suspects_;
    std::size_t n_looked_ = 0, n_of_domain_ = 0, most_points_ = 0; ///< n of vertices
    int n_sweeps_ = 0;
    Step last_ = Step::Done;
    std::array<Index, 3> asking_{}; ///< the triangle that the last place was put in for
};

} // namespace topology
