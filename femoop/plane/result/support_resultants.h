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

/// Of all held points, then of all held curves; they sum to all reactions. Of what several do to one node each has what
/// acts along the directions that it holds and none before it does, and the last one the rest.
std::vector<SupportResultant> support_resultants(const PlaneCase& result);

} // namespace femoop::plane
