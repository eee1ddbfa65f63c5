#pragma once

#include <vector>

#include "apps/plane/discretize/drawing.h"

namespace discretize {

/// Which region each face is of, as the places of the regions say.
struct FaceRegions {
    std::vector<std::optional<femoop::plane::RegionId>> of_face; ///< parallel to the drawing's faces
    std::vector<femoop::Fault> faults;
};
FaceRegions regions_of_faces(const Drawing& drawing);

/// What is wrong with a drawing whose faces have their regions: supports and loads that no material takes, divisions
/// that do not fit, checks of faces that are not there; and warnings.
std::vector<femoop::Fault> faults_of(const Drawing& drawing);

} // namespace discretize
