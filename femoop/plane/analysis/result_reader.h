#pragma once

#include <optional>
#include <vector>

#include "femoop/plane/analysis/plane_results.h"

namespace femoop::plane {

/// The places of elements that a check asks for: of its point, or of its place in the plane.
std::vector<Location> locations_of(const PlaneResults& results, const PlaneExpected& check);

/// What a check of the linear analysis compares with. \pre `check(model)` finds no error in it
double value_of(const PlaneResults& results, const PlaneCase& result, const PlaneExpected& check);

/// The largest or smallest of a stress component: over nodes, each region's value, or over integration points.
struct ExtremeQuestion {
    PlaneComponent component = PlaneComponent::sx;
    ExtremeKind which = ExtremeKind::Max;
    StressReading read = StressReading::Smoothed;
    std::optional<RegionId> region{};
    std::optional<CurveId> curve{};
    Eigen::Vector2d about = Eigen::Vector2d::Zero();
};
PlaneExtreme extreme(const PlaneCase& result, const ExtremeQuestion& question);

} // namespace femoop::plane
