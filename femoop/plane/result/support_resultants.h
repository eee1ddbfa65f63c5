#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "femoop/plane/analysis/plane_results.h"

namespace femoop::plane {

/// What one support does to the body as a whole: its springs too.
///
/// Signs  along the global axes; the moment counter-clockwise, about `at`
struct SupportResultant {
    std::optional<CurveId> curve{};               ///< that is held, or
    std::optional<NodeId> point{};                ///< that is
    Eigen::Vector2d at = Eigen::Vector2d::Zero(); ///< the point, or the middle of the curve by its length
    Eigen::Vector2d force = Eigen::Vector2d::Zero();
    double moment = 0.0;
};

/// Of all held points, then of all held curves. A node of several counts with the first of them, so that they sum to all
/// reactions.
std::vector<SupportResultant> support_resultants(const PlaneCase& result);

} // namespace femoop::plane
