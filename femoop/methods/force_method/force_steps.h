#pragma once

#include "femoop/methods/derivation/derivation.h"
#include "femoop/methods/force_method/force_method.h"

namespace femoop::force_method {

/// The method as steps with their numbers: redundants, state 0, states 1 to n, the gaps at each release member by member,
/// the equations, and the superposition of every state. Forces are those at both ends and in the middle of every member
/// of the primary structure, and reactions.
///
/// What is nothing in every state is left out.
derivation::Derivation steps(const ForceMethod& method, const Model& model);

/// "X1", counted from 1.
std::string redundant_name(std::size_t number);

} // namespace femoop::force_method
