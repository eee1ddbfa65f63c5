#pragma once

#include <cstddef>
#include <vector>

#include "femoop/methods/cross/problem.h"

namespace femoop::cross {

/// One round of Kani's method: all joints, then all sways.
struct KaniCycle {
    std::vector<double> rotation_contribution; ///< of every end: half the moment that its joint's rotation gives it
    std::vector<double> sway_contribution;     ///< of every end: the moment that the sways give it
    double largest_change = 0.0;               ///< of a rotation contribution since the cycle before
};

/// Kani's method: each joint's rotation contributions follow from its restraint moment and the contributions of the
/// far ends, again and again; nothing is added up until the end, so that a slip mends itself.
///
///      M'_AB = mu_AB (sum of FEM - load + sum of far contributions + sway contributions),   mu = -1/2 factor
///      M_AB  = FEM + 2 M'_AB + 2 C_BA M'_BA + M''_AB                       2 C = 1 for prismatic members
///
/// Source  [Kani1949]; the sway equations are those of virtual work
struct Kani {
    std::vector<double> rotation_factor; ///< mu of every end
    std::vector<KaniCycle> cycles;
    std::vector<double> moments; ///< at every end after the last cycle
    bool is_converged = false;
};

struct KaniOptions {
    double tolerance = 1e-9; ///< of the largest fixed-end moment: stops when no contribution changes more
    std::size_t most_cycles = 5000;
};

/// \throws MechanismError, ModelError where sways are resisted by nothing
Kani kani(const Model& model, const Problem& problem, const KaniOptions& options = {});

} // namespace femoop::cross
