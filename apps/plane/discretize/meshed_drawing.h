#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "apps/plane/discretize/drawing.h"
#include "apps/plane/discretize/region_mesher.h"
#include "topology/meshing/size_field.h"

namespace discretize {

/// The mesh of a drawing: a plane model with elements that the analysis takes, or what is wrong. Points of the drawing
/// that are nodes come first and keep their names; curves keep theirs, as far as there are elements beside them.
class MeshedDrawing {
public:
    /// \param is_cancelled  asked now and then; the mesh is not used when it says so
    /// \param sizes  in place of the drawing's own (MeshSettings); null: those  \pre the drawing is sound
    explicit MeshedDrawing(const Drawing& drawing, const std::function<bool()>& is_cancelled = {},
                           const std::shared_ptr<const topology::SizeField>& sizes = {});
    /// With a mesh that it has already (FollowingMesh).
    MeshedDrawing(const Drawing& drawing, RegionMesh mesh);

    const std::vector<femoop::Fault>& faults() const { return faults_; }
    bool is_sound() const { return model_ != nullptr; }

    const PlaneModel& model() const { return *model_; } ///< with its mesh. \pre it is sound
    /// Points of the model that is drawn, which come first in the mesh.
    std::size_t n_points() const { return n_points_; }
    std::optional<femoop::NodeId> node(femoop::NodeId point) const { return node_of_point_[point.index]; }
    /// The checks of the model that is drawn, each as the mesh has it; those of counts and areas as they are.
    const std::vector<femoop::plane::PlaneExpected>& checks() const { return checks_; }
    const std::vector<RegionReport>& reports() const { return reports_; } ///< of each region of the mesh
    const RegionMesh& mesh() const { return mesh_; }                      ///< in the drawing. \pre it is sound

private:
    void make_model(const Drawing& drawing, const std::vector<FaceOutline>& outlines);

    RegionMesh mesh_;
    std::shared_ptr<const PlaneModel> model_;
    std::size_t n_points_ = 0;
    std::vector<std::optional<femoop::NodeId>> node_of_point_;
    std::vector<femoop::plane::PlaneExpected> checks_;
    std::vector<RegionReport> reports_;
    std::vector<femoop::Fault> faults_;
};

} // namespace discretize
