#pragma once

#include <vector>

#include "femoop/section/outline.h"

namespace femoop {

/// Integrals over a part of a cross-section, exact for straight sides and for arcs.
struct AreaIntegrals {
    double area = 0.0, first = 0.0, second = 0.0; ///< of 1, y' and y'^2
};

/// Of what lies between two heights.
///
///     integral of y^k dA = closed integral of z y^k dy along the boundary (Green), counter-clockwise
///
/// \pre low <= high
AreaIntegrals integrals_between(const std::vector<OutlineSide>& sides, double low, double high);

/// The place along z' at which a side has a height. \pre the side reaches that height
double z_at(const OutlineSide& side, double y);

} // namespace femoop
