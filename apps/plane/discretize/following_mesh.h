#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "apps/plane/discretize/face_outline.h"
#include "apps/plane/discretize/region_mesh.h"

namespace discretize {

/// A mesh that goes along while its drawing is dragged: its elements stay, so that nothing jumps under the hand.
///
/// Nodes on curves stay at their shares of the same pieces; those inside follow as in a net of springs that are the
/// stiffer the shorter they are, so that small elements keep their shape.
class FollowingMesh {
public:
    /// \pre the drawing outlives this, and the mesh is its
    FollowingMesh(const Drawing& drawing, const RegionMesh& mesh);
    ~FollowingMesh();
    FollowingMesh(const FollowingMesh&) = delete;
    FollowingMesh& operator=(const FollowingMesh&) = delete;

    /// The mesh in the drawing as it is now; nothing where curves meet otherwise or are to be divided otherwise than in
    /// the one that it was made for. Elements may be turned inside out.
    std::optional<RegionMesh> in(const Drawing& drawing) const;

private:
    class Net;

    const Drawing& drawing_;
    std::vector<FaceOutline> outlines_;
    RegionMesh mesh_;
    std::unique_ptr<const Net> net_;
};

} // namespace discretize
