#pragma once

#include "femoop/discretisation/case_loads.h"

namespace femoop {

/// What a structure opposes to the settlements of a load case at least: its softest part moved by the largest of them,
/// a rotation counted by its arm.
double settlement_force(const Discretisation& structure, const CaseLoads& loads);

} // namespace femoop
