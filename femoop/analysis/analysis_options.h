#pragma once

#include <cstddef>
#include <string>

#include "femoop/solver/solver_options.h"

namespace femoop {

struct AnalysisOptions {
    SolverOptions solver = {};
    bool is_refined = false; ///< displacements are corrected by their residuals
};

/// Seconds spent in each phase, and the size of the system.
struct AnalysisStatistics {
    double assemble = 0.0; ///< numbers of K and of the load vectors
    double order = 0.0;    ///< order of elimination, pattern of K and of its factor
    double factor = 0.0;
    double solve = 0.0;
    std::size_t dofs = 0;
    std::size_t nonzeros = 0; ///< of the lower triangle of K
    std::size_t factor_nonzeros = 0;
    double factor_operations = 0.0; ///< multiplications with additions; 0 where the solver does not count them
    double factor_bytes = 0.0;      ///< that the factorization takes; 0 where the solver does not predict them
    std::string solver;             ///< as `--solver` takes it
    double backward_error = 0.0;    ///< of refined displacements, see RefinedSolution
    int refinements = 0;            ///< corrections made
};

} // namespace femoop
