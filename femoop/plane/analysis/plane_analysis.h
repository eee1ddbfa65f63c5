#pragma once

#include "femoop/analysis/analysis_options.h"
#include "femoop/plane/analysis/plane_results.h"
#include "femoop/plane/model/plane_model.h"

namespace femoop::plane {

/// Linear static analysis of a plane model: K u = f for every load case with one factorization, combinations by
/// superposition; by the assembler, the solvers and the balance of reactions that structures of members have.
///
/// Errors   ModelError     what `check` finds, or a system that the memory cannot hold
///          MechanismError the body can move: each independent way
///          Cancelled      by options.progress
PlaneResults analyse(const PlaneModel& model, const AnalysisOptions& options = {});

} // namespace femoop::plane
