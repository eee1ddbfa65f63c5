#pragma once

#include <vector>

#include "femoop/analysis/assembler.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/analysis/unrestrained_rotation.h"

namespace femoop {

/// Internal mechanisms of members, which their own releases leave free. What they do between their releases stands in
/// no equation, since the releases are condensed; a twist of a member that is released against torsion at both ends is
/// left out.
std::vector<Mechanism> member_mechanisms(const Model& model, const Assembler& assembler);

/// Of constrained members, whose ends have degrees of freedom, restrains what their releases leave free by stiffness in
/// K. Returns the equations restrained.
std::vector<MemberEndRestraint> restrain_member_ends(const Assembler& assembler, SparseMatrix& K);

/// Members that could twist freely, each with a torque on it in some load case: without one they are restrained.
std::vector<Mechanism> loaded_twists(const Model& model, const Assembler& assembler,
                                     const std::vector<CaseLoads>& loads);

} // namespace femoop
