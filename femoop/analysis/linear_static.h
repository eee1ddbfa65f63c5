#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "femoop/analysis/mechanism.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"
#include "femoop/solver/solver_kind.h"

namespace femoop {

struct AnalysisOptions {
    SolverKind solver = SolverKind::Automatic; ///< the fastest
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
    std::string solver; ///< as `--solver` takes it
};

/// Linear static analysis: K u = f for every load case with one factorization, combinations by superposition.
///
/// Errors   ModelError     what `check` finds, or constraints that cannot follow an imposed deformation
///          MechanismError the structure can move: each independent mechanism
/// Lesson   courseware/reference/model-file.md
Results analyse(const Model& model, const AnalysisOptions& options = {});

/// The same analysis in steps, for a model whose loads change while its structure stays: the factorization is kept.
class LinearStatic {
public:
    explicit LinearStatic(const Model& model, const AnalysisOptions& options = {}); ///< numbers, assembles, factors
    ~LinearStatic();
    LinearStatic(LinearStatic&&) noexcept;
    LinearStatic& operator=(LinearStatic&&) noexcept;

    /// Solves the loads of `model`, which has the structure that this analysis was made for.
    /// \throws std::invalid_argument if nodes or members are not as many as they were.
    Results solve(const Model& model);

    const AnalysisStatistics& statistics() const;

    struct Parts; ///< the system of equations, in femoop/analysis/linear_static.cpp

private:
    std::unique_ptr<Parts> parts_;
};

} // namespace femoop
