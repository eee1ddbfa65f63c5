#pragma once

#include <vector>

#include "femoop/analysis/assembler.h"
#include "femoop/analysis/elimination.h"

namespace femoop {

/// What the inextensible and rigid members of a structure leave free (their rows: StraightMember::ConstraintRows),
/// under the strains and settlements of each load case.
Elimination eliminate_constraints(const Assembler& assembler, const std::vector<CaseLoads>& loads);

} // namespace femoop
