#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "apps/plane/discretize/edge_divisions.h"
#include "apps/plane/discretize/region_mesh.h"
#include "topology/meshing/mesh_domain.h"
#include "topology/meshing/mesher.h"
#include "topology/meshing/trilateral_mesher.h"

namespace discretize {

/// A mesher of one outline, with what it meshes.
struct OutlineMesher {
    std::string method;
    femoop::plane::RegionId region;
    std::unique_ptr<topology::MeshDomain> domain; ///< null where the region is mapped
    std::unique_ptr<topology::Mesher> mesher;
};

/// Nodes along the curves, then the elements of one outline after another. Nodes on borders are shared, middle nodes on
/// curves lie on them.
class RegionMesher {
public:
    RegionMesher(const Drawing& drawing, const std::vector<FaceOutline>& outlines,
                 const std::vector<MeshSettings>& settings, const EdgeDivisions& divisions,
                 std::function<bool()> is_cancelled);

    void run(); ///< until an error is found, or it is cancelled

    /// Puts nodes along the curves, from which meshers of single outlines start. False where an error is found.
    bool prepare();
    /// That of an outline, with corner nodes alone. \pre prepared, or run
    OutlineMesher outline_mesher(std::size_t outline);

    RegionMesh mesh() const; ///< \pre no error was found
    const std::vector<femoop::Fault>& errors() const { return errors_; }
    const std::vector<femoop::Fault>& warnings() const { return warnings_; }

private:
    using Chain = std::vector<topology::CellNode>;
    void divide(topology::EdgeId edge);
    topology::CellNode node_at(topology::VertexId vertex);
    topology::CellNode add_node(const topology::FlatPoint& at);
    Chain chain_along(topology::HalfEdgeId h) const;
    std::vector<std::vector<topology::Cell>> rows_of(const MappedOutline& sides, const MeshSettings& settings,
                                                     const std::vector<topology::Cell>& cells) const;

    void require_possible();
    void require_one_order();
    void require_right_way_round();
    double n_expected(std::size_t outline) const;
    double n_beside(topology::HalfEdgeId h, double size) const;
    void mesh(std::size_t outline);
    Chain side_nodes(const OutlineLoop& side, const MeshSettings& settings);
    std::vector<topology::Cell> cells_of_map(const MappedOutline& outline, const MeshSettings& settings);
    std::vector<topology::Cell> cells_of_four(const topology::MappedSides& sides, const MeshSettings& settings);
    std::vector<topology::Cell> cells_of_three(const topology::TrilateralSides& sides, const MeshSettings& settings);
    std::vector<Chain> set_middles(const std::vector<Chain>& rows);
    bool are_well_shaped(const std::vector<topology::Cell>& cells) const;
    void add_mapped(const std::vector<topology::Cell>& cells, const MeshSettings& settings,
                    femoop::plane::RegionId region);
    topology::MesherOptions options_of(const FaceOutline& outline, const MeshSettings& settings,
                                       std::size_t n_nodes) const;
    std::vector<topology::Cell> cut_cells(const std::vector<topology::Cell>& cells, const MeshSettings& settings);
    void mesh_freely(const FaceOutline& outline, const MeshSettings& settings, const std::string& method);
    std::string method_of(std::size_t outline) const;
    template <class Number>
    void add_bends(const Chain& chain, const Number& number, topology::MeshDomain& domain) const;
    topology::MeshDomain domain_of(const FaceOutline& outline, Chain& of_domain) const;
    std::vector<double> sizes_of_points(const FaceOutline& outline, std::size_t n_nodes) const;
    void report_angle(const topology::CellMesh& mesh, const MeshSettings& settings, femoop::plane::RegionId region);
    void report_crossing(const topology::CrossingEdges& crossing, const FaceOutline& outline, const Chain& of_domain);
    std::string curve_through(const FaceOutline& outline, const topology::CellEdge& edge) const;
    void add_element(const topology::Cell& cell, const MeshSettings& settings, femoop::plane::RegionId region);
    topology::CellNode middle_node(topology::CellNode a, topology::CellNode b);
    void set_middle(topology::CellNode a, topology::CellNode b, topology::CellNode node);
    topology::CellNode centre_node(const std::vector<topology::CellNode>& nodes);
    std::string entry(femoop::plane::RegionId region) const;

    const Drawing& drawing_;
    const std::vector<FaceOutline>& outlines_;
    const std::vector<MeshSettings>& settings_;
    const EdgeDivisions& divisions_;
    std::function<bool()> is_cancelled_;
    std::vector<topology::FlatPoint> nodes_;
    std::vector<std::optional<topology::CellNode>> of_vertex_;
    std::vector<Chain> chains_;
    std::vector<bool> is_quadratic_; ///< of each edge: elements beside it have middle nodes
    std::unordered_map<std::uint64_t, topology::CellNode> middles_;
    std::vector<MeshedElement> elements_;
    std::vector<RegionReport> reports_;
    std::vector<femoop::Fault> errors_, warnings_;
};

} // namespace discretize
