#pragma once

#include "ui/paint/geometry.h"

#include <span>
#include <vector>

namespace euler {

/// Where a name can stand inside an outline.
struct NamePlaces {
    std::vector<ui::Point> all; ///< the place with most room first; not empty
    double room = 0.0;          ///< [px] about that one
};

/// Places of a grid across the outline that lie inside it, those with more room first.
NamePlaces places_inside(std::span<const ui::Point> outline);

} // namespace euler
