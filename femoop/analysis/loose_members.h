#pragma once

#include <cstdint>
#include <vector>

#include "femoop/analysis/assembly.h"
#include "femoop/analysis/idle_rotation.h"
#include "femoop/analysis/mechanism.h"

namespace femoop {

/// Members that their own releases leave loose. What they do between their releases stands in no equation, since the
/// releases are condensed; a twist of a member that is released against torsion at both ends is left out.
template <AnalysisKind kind>
std::vector<Mechanism> loose_members(const Model& model, const Structure& structure, const Assembly<kind>& assembly);

/// Of constrained members, whose own ends are unknowns, holds what their releases leave loose by stiffness in K.
/// Returns the equations held.
template <AnalysisKind kind>
std::vector<HeldEnd> hold_loose_own_ends(const Structure& structure, const Equations& equations,
                                         const Assembly<kind>& assembly, SparseMatrix& K);

/// Members that could twist freely, each with a torque on it in some load case: without one they are held.
template <AnalysisKind kind>
std::vector<Mechanism> driven_twists(const Model& model, const Structure& structure, const Assembly<kind>& assembly,
                                     const std::vector<CaseLoads>& loads);

} // namespace femoop
