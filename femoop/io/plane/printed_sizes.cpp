#include "femoop/io/plane/printed_sizes.h"

#include <algorithm>
#include <cmath>

#include "femoop/plane/mesh/mesh_geometry.h"
#include "femoop/result/magnitudes.h"

namespace femoop::plane {

PlaneMagnitudes::PlaneMagnitudes(const PlaneResults& results, const PlaneCase& result)
{
    for (std::size_t i = 0; i < results.model().points.size(); ++i) {
        displacement = std::max(displacement, result.displacement(NodeId(i)).norm());
        force = std::max(force, result.reaction(NodeId(i)).norm());
        reach = std::max(reach, position(results.model().points[i]).norm());
    }
}

double PlaneMagnitudes::moved(double u) const
{
    constexpr double digits_lost = 10.0; // in moving a body as a whole
    return without_rounding(u, digits_lost * displacement);
}

SizeOfSums::SizeOfSums(const PlaneCase& result)
{
    for (const Eigen::Vector2d& at : result.structure().positions()) reach_ = std::max(reach_, at.norm());
    const Equilibrium sums = result.equilibrium();
    for (const NodeVector& of : {sums.sum_loads, sums.sum_reactions})
        force_ += std::abs(of[0]) + std::abs(of[1]) + std::abs(of[5]) / reach_;
}

CutForces without_rounding_of(const CutForces& forces, const Cut& cut)
{
    const double size = std::abs(forces.N) + std::abs(forces.V) + std::abs(forces.M) / cut.length();
    return {without_rounding(forces.N, size), without_rounding(forces.V, size),
            without_rounding(forces.M, size * cut.length())};
}

/// One place of each region that a place is in.
std::vector<std::pair<RegionId, Location>> places_at(const PlaneResults& results, const Eigen::Vector2d& at)
{
    std::vector<std::pair<RegionId, Location>> places;
    for (const Location& place : results.locator().find(at)) {
        const RegionId region = results.model()[place.element].region;
        if (std::ranges::find(places, region, &std::pair<RegionId, Location>::first) == places.end())
            places.emplace_back(region, place);
    }
    return places;
}

} // namespace femoop::plane
