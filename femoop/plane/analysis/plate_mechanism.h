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

/// Does a motion of all nodes (ux and uy of each) deform any element, by more than rounding leaves of a motion that is
/// none of its own? A slender body is soft, and yet each of its elements is strained where it bends.
bool strains(const PlaneStructure& structure, const std::vector<double>& u);

} // namespace femoop::plane
