#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apps/plane/discretize/region_mesher.h"

namespace discretize {

/// How the mesh of a drawing comes to be, step by step and back: its outlines one after the other. The steps are those by
/// which `MeshedDrawing` meshes it; what comes after them, middle nodes and the righting of elements at curves, is not
/// among them.
class MeshPlayer {
public:
    /// Runs once to the end, to count the steps. \param sizes  as of MeshedDrawing  \pre the drawing has a sound mesh, and outlives the player
    explicit MeshPlayer(const Drawing& drawing, const std::shared_ptr<const topology::SizeField>& sizes = {});
    MeshPlayer(const MeshPlayer&) = delete;
    MeshPlayer& operator=(const MeshPlayer&) = delete;

    std::size_t n_steps() const { return n_steps_; }
    std::size_t place() const { return place_; } ///< steps that are done
    /// Backwards by beginning anew: the same drawing has the same steps. Past the end it stays there.
    void go_to(std::size_t place);

    std::optional<topology::MeshStep> step() const { return step_; } ///< the last one; nothing before the first
    topology::MeshMarks marks() const;
    std::string method() const { return meshers_.back().method; } ///< of the outline under way
    femoop::plane::RegionId region() const { return meshers_.back().region; }
    std::vector<topology::CellMesh> meshes() const; ///< of outlines that are done, then of the one under way

private:
    void restart();
    bool forward();

    const Drawing& drawing_;
    std::vector<FaceOutline> outlines_;
    std::vector<MeshSettings> settings_;
    EdgeDivisions divisions_;
    RegionMesher regions_;
    std::vector<OutlineMesher> meshers_; ///< up to the one under way
    std::optional<topology::MeshStep> step_;
    std::size_t place_ = 0, n_steps_ = 0;
};

} // namespace discretize
