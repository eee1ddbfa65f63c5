#pragma once

#include <vector>

#include "femoop/analysis/mechanism.h"
#include "femoop/plane/analysis/plane_structure.h"

namespace femoop::plane {

/// The ways in which parts of a body move without strain, as far as they are rigid: a part is what elements join edge by
/// edge; parts that meet in one node turn about it.
///
/// Method  null space of what supports, springs, ties and common nodes ask of three motions of each part
std::vector<Mechanism> rigid_motions(const PlaneStructure& structure);

} // namespace femoop::plane
