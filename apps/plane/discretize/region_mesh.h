#pragma once

#include <optional>
#include <string>
#include <vector>

#include "femoop/plane/model/plane_model.h"
#include "topology/meshing/mesh_domain.h"
#include "topology/planar/planar_subdivision.h"

namespace discretize {

/// An element as nodes of all regions' mesh: corners, then middle nodes, then the centre.
struct MeshedElement {
    std::vector<topology::CellNode> nodes;
    femoop::ShapeKind kind = femoop::ShapeKind::T3;
    femoop::plane::RegionId region;
};

/// How a region was meshed.
struct RegionReport {
    std::string method;
    double seconds = 0.0;
};

/// A node between the ends of an edge, at a share of its length in its plus direction.
struct NodeOnEdge {
    topology::CellNode node = 0;
    topology::EdgeId edge;
    double share = 0.0;
};

/// The mesh of all regions of a drawing, and where its nodes are in the drawing.
struct RegionMesh {
    std::vector<topology::FlatPoint> nodes;
    std::vector<MeshedElement> elements;
    std::vector<std::optional<topology::CellNode>> of_vertex; ///< by vertex
    std::vector<std::vector<topology::CellNode>> chains; ///< by edge: corner nodes in its plus direction, ends included
    std::vector<NodeOnEdge> on_edges;                    ///< middle nodes too
    std::vector<RegionReport> reports;                   ///< by region of the model
};

/// The place at a share of an edge's length.
topology::FlatPoint place_on_edge(const topology::PlanarSubdivision& plane, topology::EdgeId edge, double share);

} // namespace discretize
