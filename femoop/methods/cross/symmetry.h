#pragma once

#include <vector>

#include "femoop/methods/cross/problem.h"

namespace femoop::cross {

/// The shortcut that symmetry offers: half of the joints are balanced, the others are their mirror images.
///
///        A    B  :  C    D        symmetric      M_CB = -M_BC   the member BC takes 2EI/L, nothing is carried over
///        |----o--:--o----|        antisymmetric  M_CB = +M_BC   it takes 6EI/L
///               axis
///
/// In numbers: an end with the stiffness s and the carry-over C whose member crosses the axis takes s - Cs or s + Cs. A
/// joint on the axis of a symmetric sheet does not turn; on that of an antisymmetric one it is balanced as it is.
///
/// Each sheet is symmetric or antisymmetric by itself: of the loads, and of every sway. A sway of the other kind than
/// the loads, whose prop they leave unrestrained, does not happen: it has no sheet.
///
/// Assumes  a vertical axis in the middle of the structure
/// \throws  ModelError  CrossNodeWithoutImage, CrossEndWithoutImage, CrossSkewLoads, CrossSkewSway
Problem by_halves(const Model& model, const Problem& whole);

/// Ends on the sheet of a half whose members cross the axis at a joint that is balanced.
std::vector<EndId> crossing_ends(const Problem& half);

} // namespace femoop::cross
