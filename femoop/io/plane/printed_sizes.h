#pragma once

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

#include "femoop/model/dof.h"
#include "femoop/plane/analysis/plane_results.h"

namespace femoop::plane {

/// How large the numbers of a case are: what is far smaller is rounding.
struct PlaneMagnitudes {
    PlaneMagnitudes(const PlaneResults& results, const PlaneCase& result);
    double moved(double u) const; ///< without what is rounding beside the largest displacement

    double displacement = 0.0, force = 0.0, reach = 0.0; ///< of one node; from the origin
};

inline constexpr std::array plane_sums{Dof::ux, Dof::uy, Dof::rz};

/// The same of the sums of forces, and of moments by the reach of the farthest node.
class SizeOfSums {
public:
    explicit SizeOfSums(const PlaneCase& result);
    double of(Dof dof) const { return is_rotation(dof) ? force_ * reach_ : force_; }

private:
    double reach_ = 0.0, force_ = 0.0;
};

CutForces without_rounding_of(const CutForces& forces, const Cut& cut);

/// One place of each region that a place is in.
std::vector<std::pair<RegionId, Location>> places_at(const PlaneResults& results, const Eigen::Vector2d& at);

} // namespace femoop::plane
