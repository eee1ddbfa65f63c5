#pragma once

#include <optional>

#include "femoop/solver/progress.h"
#include "femoop/solver/solver_kind.h"

namespace femoop {

/// Which solver, and what it minds. Its kind alone is enough said.
struct SolverOptions {
    SolverKind kind;
    Progress progress;                  ///< hears of factorizations and may cancel them
    std::optional<double> memory_limit; ///< bytes that a factorization may take; empty: what the machine has free

    SolverOptions(SolverKind wanted = SolverKind::Automatic) : kind(wanted) {} // NOLINT: meant to convert
};

} // namespace femoop
