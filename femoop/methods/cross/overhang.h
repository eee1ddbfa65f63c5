#pragma once

#include <vector>

#include "femoop/methods/cross/member_action.h"

namespace femoop::cross {

/// Parts that hang on one node and are held nowhere else: statics alone finds their end moments.
struct Overhangs {
    std::vector<bool> is_tip; ///< of every node: it belongs to an overhang, its root aside
};

/// Takes the overhangs off: their members get their end moments in `f` and no stiffness, and their forces go to the
/// node that they hang on.
Overhangs take_off_overhangs(const Discretisation& structure, std::vector<LoadedMember>& members, CaseForces& forces);

} // namespace femoop::cross
