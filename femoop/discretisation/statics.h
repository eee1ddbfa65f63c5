#pragma once

#include "femoop/model/dof.h"

namespace femoop {

/// How many more forces there are than equations of equilibrium to find them.
///
/// total = external + internal; 0 is statically determinate. Springs and settlements count as supports.
/// Source  [Kassimali, ch. 3] for `external` (reactions less the equations of the whole),
///         `total` from the rank of the equilibrium equations of all nodes.
struct Indeterminacy {
    int external = 0;
    int internal = 0;
    bool has_foundation = false; ///< a continuous foundation makes the true number infinite: the two leave it out
    int total() const { return external + internal; }
};

/// Equilibrium of the structure as a whole, and of its worst node.
struct Equilibrium {
    double residual = 0.0;      ///< largest out-of-balance force over the largest load
    NodeVector sum_loads{};     ///< moments about the origin
    NodeVector sum_reactions{}; ///< supports, springs and foundations
};

} // namespace femoop
