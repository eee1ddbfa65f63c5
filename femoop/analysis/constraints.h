#pragma once

#include <vector>

#include "femoop/analysis/assembler.h"
#include "femoop/analysis/elimination.h"

namespace femoop {

/// What inextensible and rigid members impose on the unknowns (their rows: StraightMember::ConstraintRows), under the
/// strains and settlements of each load case. A row may have no terms: where supports hold all of it.
std::vector<ConstraintRow> constraint_rows(const Assembler& assembler, const std::vector<CaseLoads>& loads);

/// What the inextensible and rigid members of a structure leave free, under the same.
Elimination eliminate_constraints(const Assembler& assembler, const std::vector<CaseLoads>& loads);

} // namespace femoop
