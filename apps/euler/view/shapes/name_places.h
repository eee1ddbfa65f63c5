#pragma once

#include "apps/euler/view/shapes/outline.h"

#include <vector>

namespace euler {

/// Where a name can stand inside an area.
struct NamePlaces {
    std::vector<ui::Point> all; ///< the place with most room first; not empty
    double room = 0.0;          ///< [px] about that one
};

/// Places of a grid across the area that lie inside it, those with more room first.
NamePlaces places_inside(const Region& area);

} // namespace euler
