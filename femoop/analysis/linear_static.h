#pragma once

#include <memory>

#include "femoop/analysis/analysis_options.h"
#include "femoop/analysis/control.h"
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
/// Reference courseware/reference/model-file.md
Results analyse(const Model& model, const AnalysisOptions& options = {});

/// The same analysis in steps, for a model that changes while its structure stays: what did not change is kept.
///
///     LinearStatic analysis(model);      // numbers, assembles, factors
///     analysis.solve(model);             // again after any change of loads
///     analysis.update(model);            // after a change of values: assembles and factors, in the order there is
class LinearStatic final : public Control {
public:
    explicit LinearStatic(const Model& model, const AnalysisOptions& options = {});
    ~LinearStatic() override;
    LinearStatic(LinearStatic&&) noexcept;
    LinearStatic& operator=(LinearStatic&&) noexcept;

    /// Solves the loads of `model`, which has the structure that this analysis was made for.
    /// \throws std::invalid_argument if nodes or members are not as many as they were.
    Results solve(const Model& model) override;

    /// Takes on a model whose nodes lie elsewhere, or whose members and springs have other properties. Where the same
    /// displacements are unknown and the same ones coupled, the order of elimination and all symbolic work are kept;
    /// else it begins anew. \throws what the constructor throws; then this can only be updated, assigned or destroyed.
    void update(const Model& model);

    const AnalysisStatistics& statistics() const override;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace femoop
