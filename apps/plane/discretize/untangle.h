#pragma once

#include <vector>

#include "apps/plane/discretize/region_mesher.h"

namespace discretize {

/// Moves nodes inside until elements that curves have turned inside out, or nearly so, are the right way round: each to
/// the best of the places around it that leaves no flat angle, again and again, the worst element first. Others stay where
/// they are.
///
/// \param nodes  of all elements  \param is_held  nodes that must stay: those of curves, and points
void untangle(std::vector<topology::FlatPoint>& nodes, const std::vector<MeshedElement>& elements,
              const std::vector<bool>& is_held);

} // namespace discretize
