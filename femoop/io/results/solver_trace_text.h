#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "femoop/analysis/solver_trace.h"
#include "femoop/model/fault/translator.h"
#include "femoop/solver/ordering.h"

namespace femoop {

/// What of a solver's trace is written.
struct SolverTraceRequest {
    std::optional<Ordering> ordering; ///< whose fronts walk: the solver's own when absent
    std::optional<std::size_t> step;  ///< from 0: the matrix of this front as well. \pre below the number of fronts
};

/// Who solves the system and in which order; four orders of elimination side by side with what they cost; the fronts
/// one after the other, and the pattern of L where it is small enough for letters.
std::string solver_trace_text(const SolverTrace& trace, const SolverTraceRequest& request, const Translator& tr);

/// All of it, with the walks of all four orders; of a large system the counts alone.
std::string solver_trace_json(const SolverTrace& trace);

/// The order whose fronts are shown where none is asked for.
Ordering usual_ordering(const SolverTrace& trace);

/// "reverse Cuthill-McKee", in the reader's language.
std::string ordering_text(Ordering ordering, const Translator& tr);

} // namespace femoop
