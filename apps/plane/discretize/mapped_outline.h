#pragma once

#include <optional>
#include <vector>

#include "apps/plane/discretize/face_outline.h"
#include "apps/plane/discretize/mesh_settings.h"

namespace discretize {

/// The outline of a mapped region from corner to corner, counter-clockwise from the first corner: four sides, of a
/// trilateral region three.
using MappedOutline = std::vector<OutlineLoop>;

/// The sides of an outline, or why it has none.
struct MappedAttempt {
    std::optional<MappedOutline> sides;
    std::optional<femoop::Fault> fault;
};
MappedAttempt mapped_outline(const Drawing& drawing, const FaceOutline& outline, const MeshSettings& settings);

} // namespace discretize
