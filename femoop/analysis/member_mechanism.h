#pragma once

#include <vector>

#include "femoop/analysis/assembler.h"
#include "femoop/analysis/unrestrained_rotation.h"
#include "femoop/element/internal_mechanism.h"

namespace femoop {

/// A member that its own releases leave free.
struct LooseMember {
    MemberId member;
    InternalMechanism motion;
};

/// All of them, once for each motion. What they do between their releases stands in no equation, since the releases are
/// condensed; a twist of a member that is released against torsion at both ends is left out.
std::vector<LooseMember> loose_members(const Assembler& assembler);

/// Of constrained members, whose ends have degrees of freedom, restrains what their releases leave free by stiffness in
/// K. Returns the equations restrained.
std::vector<MemberEndRestraint> restrain_member_ends(const Assembler& assembler, SparseMatrix& K);

/// Members that could twist freely, each with a torque on it in some load case: without one they are restrained.
std::vector<LooseMember> loaded_twists(const Assembler& assembler, const std::vector<CaseLoads>& loads);

} // namespace femoop
