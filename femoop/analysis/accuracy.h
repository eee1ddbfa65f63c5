#pragma once

#include <cstdint>
#include <vector>

#include "femoop/discretisation/solution.h"
#include "femoop/model/fault/fault.h"

namespace femoop {

/// By what part of themselves the forces of a load case fail to balance, at the worst unknown and as a whole: about
/// 1e-16 times what the structure's size makes of rounding. \pre reactions are filled in
double imbalance(const detail::CaseSolution& solution);

/// Are there cases whose displacements need more digits than doubles have, for forces to be found from them?
bool needs_precision(const detail::Solution& solution);

/// What part of the forces that settlements and heat would bring, if all were held, single forces are measured by at
/// least: where nothing holds against a settlement no force is left but rounding.
enum class LeastForce : std::uint8_t { OfMembers, OfBodies };
/// Warns of cases that balance to less than eight digits.
std::vector<Fault> inaccurate_cases(const detail::Solution& solution, LeastForce least = LeastForce::OfMembers);
/// Cases that balance to less than three digits, and of bodies those of whose loads no digit is balanced, which nobody
/// should see.
std::vector<Fault> ill_conditioned_cases(const detail::Solution& solution, LeastForce least = LeastForce::OfMembers);
std::vector<Fault> unsolved_cases(const detail::Solution& solution); ///< the same of every load case

} // namespace femoop
