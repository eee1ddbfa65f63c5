#include "apps/euler/view/solid/placed_solid.h"

#include <utility>

namespace euler {

PlacedSolid::PlacedSolid(std::size_t number, const Subject& subject, const ViewTransform& transform, double explosion)
    : place(number),
      solid(*subject.solid),
      marks(solid, subject.marks),
      positions(solid, marks, transform),
      paths(solid, positions, transform),
      bodies(solid, paths)
{
    bodies.explode(solid, explosion, positions.extent());
}

PlacedSolid::PlacedSolid(std::size_t number, const Subject& subject, const ViewTransform& transform, Layout layout)
    : place(number),
      solid(*subject.solid),
      marks(solid, subject.marks),
      positions(std::move(layout.vertices)),
      paths(solid, positions, transform, std::move(layout.curves)),
      bodies(solid, paths),
      left_out_(std::move(layout.left_out))
{
    bodies.lay_flat(layout.outside);
}

PlacedSolids placed_in_space(std::span<const Subject> subjects, const ViewTransform& transform, double explosion)
{
    PlacedSolids placed;
    for (std::size_t i = 0; i < subjects.size(); ++i)
        placed.push_back(std::make_unique<PlacedSolid>(i, subjects[i], transform, explosion));
    return placed;
}

} // namespace euler
