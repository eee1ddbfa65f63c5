#pragma once

#include <vector>

#include "femoop/analysis/assembly.h"
#include "femoop/analysis/elimination.h"

namespace femoop {

/// What the inextensible and rigid members of a structure leave free:
///
///      u2 - u1 = strain L        and if rigid    phi2 - phi1 = curvature L,  v2 - v1 - L phi1 = curvature L^2 / 2
template <AnalysisKind kind>
Elimination eliminate_constraints(const Discretisation& structure, const Equations& equations,
                                  const Assembly<kind>& assembly, const std::vector<CaseLoads>& loads);

} // namespace femoop
