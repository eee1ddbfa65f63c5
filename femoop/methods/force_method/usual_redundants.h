#pragma once

#include <vector>

#include "femoop/discretisation/statics.h"
#include "femoop/methods/force_method/primary_structure.h"

namespace femoop::force_method {

/// As many are chosen by the program, and no more: so many equations are solved by hand by nobody.
inline constexpr int most_redundants = 30;

/// Redundants that leave the structure statically determinate, the first that do so in this order: reactions, of supports
/// that most members meet first, of those that hold least, from the last node back; then of the members, from the last
/// back, moments at their ends, those in the middle of members on a foundation and the other section forces at their
/// starts. None of a determinate structure.
///
/// \param degree  of static indeterminacy; what a foundation adds is left in the primary structure: where there are no
///                others, one force is chosen that the structure can do without
/// \throws ModelError  RedundantsTooMany where there are more than most_redundants
std::vector<Redundant> usual_redundants(const Model& model, const Indeterminacy& degree);

/// Whether a structure with these redundants released can neither move nor be moved by what stands for them.
bool is_stable(const Model& model, std::span<const Redundant> redundants);

} // namespace femoop::force_method
