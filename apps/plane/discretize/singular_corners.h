#pragma once

#include <vector>

#include "apps/plane/discretize/drawing.h"

namespace discretize {

/// A corner where the material takes up more than a straight angle and no fillet rounds it: elastic stresses have no
/// bound there, and what a mesh finds grows with every finer one.
///
///      |######          Near it they go with r^(lambda - 1). Where no load acts on the two sides, lambda is the least
///      |######          root above 0 of  sin(lambda angle) = -lambda sin(angle);  at 270 degrees 0.5445
///      +---+#####
///     270 degrees
struct SingularCorner {
    topology::FlatPoint at;
    double angle = 0.0; ///< of the material [degrees]
};

/// Those of the outline, region borders aside, by their places; corners of less than 185 degrees, as outlines of short
/// straight parts have in place of curves, are none. \pre the drawing is sound
std::vector<SingularCorner> singular_corners(const Drawing& drawing);

} // namespace discretize
