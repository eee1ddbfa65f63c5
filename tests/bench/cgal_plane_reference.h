#pragma once

#include <cstddef>
#include <vector>

#include "topology/geometry/curve.h"
#include "topology/meshing/mesh_domain.h"

namespace bench {

/// What CGAL makes of a domain, and how long it takes.
struct CgalMesh {
    std::size_t triangles = 0;
    double seconds = 0.0;
};
/// By its Delaunay_mesher_2, with angles of 30 degrees or more and the boundary as it is given at first.
/// \param longest  edge that a triangle may have
/// \param holes    a place in each
CgalMesh cgal_mesh(const topology::MeshDomain& domain, double longest, const std::vector<topology::FlatPoint>& holes);

/// What lines make of the plane in CGAL's Arrangement_2, which computes exactly, and how long it takes.
struct CgalRegions {
    std::size_t regions = 0;
    double seconds = 0.0;
};
CgalRegions cgal_sweep(const std::vector<topology::Segment>& segments);      ///< all at once
CgalRegions cgal_one_by_one(const std::vector<topology::Segment>& segments); ///< each found by a walk

} // namespace bench
