#pragma once

#include "femoop/discretisation/case_loads.h"

namespace femoop {

/// What a structure opposes to the settlements of a load case at least: its softest part moved by the largest of them,
/// a rotation counted by its arm.
double settlement_force(const Discretisation& structure, const CaseLoads& loads);

/// The largest force that springs which settle would bring if the bodies on them stood still, but of each spring no more
/// than this part of what bodies oppose to its settlement: against a firmer spring it is they that give way.
double sprung_force(const Discretisation& structure, const CaseLoads& loads, double part);

} // namespace femoop
