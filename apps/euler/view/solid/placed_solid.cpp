#include "apps/euler/view/solid/placed_solid.h"

#include <utility>

namespace euler {

PlacedSolid::PlacedSolid(std::size_t number, const Subject& subject, const Sight& sight, double explosion)
    : place(number),
      solid(*subject.solid),
      marks(solid, subject.marks),
      stations(solid, marks, sight),
      paths(solid, stations, sight),
      bodies(solid, paths)
{
    bodies.explode(solid, explosion, stations.extent());
}

PlacedSolid::PlacedSolid(std::size_t number, const Subject& subject, const Sight& sight, Layout layout)
    : place(number),
      solid(*subject.solid),
      marks(solid, subject.marks),
      stations(std::move(layout.vertices)),
      paths(solid, stations, sight, std::move(layout.curves)),
      bodies(solid, paths),
      left_out_(std::move(layout.left_out))
{
    bodies.lay_flat(layout.outside);
}

PlacedSolids placed_in_space(std::span<const Subject> subjects, const Sight& sight, double explosion)
{
    PlacedSolids placed;
    for (std::size_t i = 0; i < subjects.size(); ++i)
        placed.push_back(std::make_unique<PlacedSolid>(i, subjects[i], sight, explosion));
    return placed;
}

} // namespace euler
