#pragma once

#include "femoop/discretisation/solution.h"

namespace femoop {

/// Fills in reactions and the sums of loads and reactions of every load case, from the forces at members' ends.
void add_reactions(detail::Solution& solution);

/// Counts unknown forces less equations of equilibrium. \pre the structure is no mechanism
Indeterminacy count_indeterminacy(const Discretisation& structure, std::size_t n_restraints);

} // namespace femoop
