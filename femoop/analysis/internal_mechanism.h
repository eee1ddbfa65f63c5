#pragma once

#include <cstdint>
#include <vector>

#include "femoop/analysis/assembly.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/analysis/unrestrained_rotation.h"

namespace femoop {

/// Internal mechanisms of members, which their own releases leave free. What they do between their releases stands in
/// no equation, since the releases are condensed; a twist of a member that is released against torsion at both ends is
/// left out.
template <AnalysisKind kind>
std::vector<Mechanism> internal_mechanisms_of(const Model& model, const Discretisation& structure,
                                              const Assembly<kind>& assembly);

/// Of constrained members, whose ends have degrees of freedom, restrains what their releases leave free by stiffness in
/// K. Returns the equations restrained.
template <AnalysisKind kind>
std::vector<MemberEndRestraint> restrain_member_ends(const Discretisation& structure, const Equations& equations,
                                                     const Assembly<kind>& assembly, SparseMatrix& K);

/// Members that could twist freely, each with a torque on it in some load case: without one they are restrained.
template <AnalysisKind kind>
std::vector<Mechanism> loaded_twists(const Model& model, const Discretisation& structure,
                                     const Assembly<kind>& assembly, const std::vector<CaseLoads>& loads);

} // namespace femoop
