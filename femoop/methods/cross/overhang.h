#pragma once

#include <vector>

#include "femoop/methods/cross/member_action.h"

namespace femoop::cross {

/// Parts that hang on one node and are held nowhere else: statics alone finds their end moments.
struct Overhangs {
    /// One member of an overhang.
    struct Part {
        NodeId root, tip;     ///< its node towards the structure, and the other one
        Eigen::Vector2d axis; ///< along the member
    };

    std::vector<bool> is_tip; ///< of every node: it belongs to an overhang, its root aside
    std::vector<Part> parts;  ///< each after those that hang on it
};

/// Takes the overhangs off: their members get their end moments in `f` and no stiffness, and their forces go to the
/// node that they hang on.
Overhangs take_off_overhangs(const Discretisation& structure, std::vector<LoadedMember>& members, CaseForces& forces);

/// Takes the overhangs along with displacements of the structure. Only where no rotation of the root would move the tip
/// too: along members that lie along x or y.
void carry_over_load(const Overhangs& overhangs, std::vector<Eigen::Vector2d>& displacement);

} // namespace femoop::cross
