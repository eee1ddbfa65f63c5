#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/plane/discretize/face_outline.h"
#include "apps/plane/discretize/region_mesh.h"

namespace discretize {

/// Puts a mesh into the form of a plane model with elements: what points, curves and regions carry in the drawing, the
/// nodes and elements carry.
class MeshModelMaker {
public:
    MeshModelMaker(const Drawing& drawing, const std::vector<FaceOutline>& outlines, const RegionMesh& mesh);

    PlaneModel model();
    const std::vector<femoop::Fault>& errors() const { return errors_; }
    std::size_t n_points() const { return n_points_; }
    const std::vector<std::optional<femoop::NodeId>>& node_of_point() const { return node_of_point_; }
    std::vector<femoop::plane::PlaneExpected> checks() const; ///< all, as the mesh has them
    const std::vector<std::optional<femoop::plane::RegionId>>& regions() const { return region_of_; }

private:
    void add_points(PlaneModel& model);
    void add_regions(PlaneModel& model);
    void add_elements(PlaneModel& model) const;
    void add_curves(PlaneModel& model);
    void add_load_cases(PlaneModel& model) const;
    femoop::plane::PlaneExpected meshed(const femoop::plane::PlaneExpected& drawn) const;
    std::vector<topology::CellNode> chain_along(const CurvePiece& piece) const;
    std::vector<femoop::plane::CurveId> meshed(const std::vector<femoop::plane::CurveId>& curves) const;
    std::optional<femoop::plane::RegionLoad> meshed(const femoop::plane::RegionLoad& load) const;
    femoop::NodeId node(topology::CellNode node) const { return *number_of_[node]; }

    const Drawing& drawing_;
    const PlaneModel& drawn_;
    const std::vector<FaceOutline>& outlines_;
    const RegionMesh& mesh_;
    std::vector<bool> is_used_;                            ///< of each node of the mesh
    std::vector<std::optional<femoop::NodeId>> number_of_; ///< of the same, in the model
    std::vector<std::optional<femoop::NodeId>> node_of_point_;
    std::vector<std::optional<femoop::plane::CurveId>> curve_of_;
    std::vector<std::optional<femoop::plane::RegionId>> region_of_;
    std::size_t n_points_ = 0;
    std::vector<femoop::Fault> errors_;
};

} // namespace discretize
