#pragma once

#include <memory>

#include "femoop/analysis/analysis_options.h"
#include "femoop/analysis/mechanism.h"
#include "femoop/model/model.h"
#include "femoop/result/results.h"

namespace femoop {

/// Linear static analysis: K u = f for every load case with one factorization, combinations by superposition.
///
/// Errors   ModelError     what `check` finds, or constraints that cannot follow an imposed deformation
///                         or a system that the memory cannot hold
///          MechanismError the structure can move: each independent mechanism
///          Cancelled      by options.progress
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
