#pragma once

#include <cstddef>
#include <random>

#include "topology/meshing/mesh_domain.h"

/// A square of side 1 with both sides divided, and a round hole of 24 parts unless its radius is 0.
topology::MeshDomain square_with_hole(std::size_t n_parts, double radius);

/// One loop of places.
topology::MeshDomain polygon(const std::vector<topology::FlatPoint>& places);

/// A star of random reach: places around the origin at ascending angles.
topology::MeshDomain random_star(std::mt19937& random);

double area(const topology::CellMesh& mesh);
double smallest_angle(const topology::CellMesh& mesh); ///< [degrees]

/// How often each edge bounds a cell that lies to its left, and to its right, put together as the contracts of a mesh:
/// every edge inside lies between two cells that run against each other, every edge of the outline beside one.
void check_edges(const topology::MeshDomain& domain, const topology::CellMesh& mesh);

/// Each triangle has area, all fill the domain, Euler's relation holds: T = 2 V - B - 2 + 2 h; and `check_edges`.
void check_triangles(const topology::MeshDomain& domain, const topology::CellMesh& mesh);
