#pragma once

#include <vector>

#include "apps/plane/discretize/drawing.h"

namespace discretize {

/// A warning of each vertex that several places of the drawing have become, as they were closer to each other than `snap`:
/// points, ends of curves, and curves that pass. What round-off alone keeps apart is no merge.
std::vector<femoop::Fault> merged_places(const Drawing& drawing);

} // namespace discretize
