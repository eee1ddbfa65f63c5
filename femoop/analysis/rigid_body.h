#pragma once

#include <vector>

#include "femoop/discretisation/discretisation.h"
#include "femoop/model/fault/fault.h"

namespace femoop {

/// Every part of the structure that supports, springs and foundations do not hold as a rigid body. A part is what
/// members join, whatever their releases.
///
/// Method  rank of the rigid motions (three in the plane, six in space) at what holds the part
std::vector<Fault> unheld_parts(const Model& model, const Discretisation& structure);

} // namespace femoop
