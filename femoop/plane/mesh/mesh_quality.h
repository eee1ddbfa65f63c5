#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "femoop/plane/model/plane_model.h"

namespace femoop::plane {

/// How well elements are shaped: the angles between their straight corner lines [degrees], and the least scaled
/// Jacobian at corners: det J over the lengths of the two edges that meet there, 1 of a right angle.
struct MeshQuality {
    double min_angle = 180.0, max_angle = 0.0;
    double min_jacobian = 1.0;
};
MeshQuality mesh_quality(const PlaneModel& model, std::optional<RegionId> region = {}); ///< of one region, or of all

struct RegionSize {
    std::size_t n_elements = 0;
    double area = 0.0; ///< as the elements' sides draw it
};
std::vector<RegionSize> region_sizes(const PlaneModel& model); ///< of each region

} // namespace femoop::plane
