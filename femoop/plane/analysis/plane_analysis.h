#pragma once

#include <memory>

#include "femoop/analysis/analysis_options.h"
#include "femoop/plane/analysis/plane_results.h"
#include "femoop/plane/model/plane_model.h"

namespace femoop {
class StaticSystem;
} // namespace femoop

namespace femoop::plane {

/// Linear static analysis of a plane model: K u = f for every load case with one factorization, combinations by
/// superposition; by the assembler, the solvers and the balance of reactions that structures of members have.
///
/// Errors   ModelError     what `check` finds, or a system that the memory cannot hold
///          MechanismError the body can move: each independent way
///          Cancelled      by options.progress
PlaneResults analyse(PlaneModel model, const AnalysisOptions& options = {});

/// The same analysis again and again, for a mesh whose nodes move while its elements stay.
///
///     PlaneAnalysis analysis;
///     analysis.solve(mesh);
///     analysis.solve(moved_mesh);   // assembles and factors, in the order of elimination that there is
class PlaneAnalysis {
public:
    explicit PlaneAnalysis(AnalysisOptions options = {});
    ~PlaneAnalysis();

    /// Where the same displacements are unknown and the same ones coupled as the last time, all symbolic work is kept.
    /// \throws what `analyse` throws; it can be used again after that.
    PlaneResults solve(PlaneModel model);
    PlaneResults solve_sound(PlaneModel model); ///< likewise. \pre `check(model)` finds no error

private:
    struct Solved;
    Solved solved(const std::shared_ptr<const PlaneStructure>& structure, const std::vector<CaseLoads>& loads);
    std::unique_ptr<StaticSystem> numbered(const PlaneStructure& structure, Solved& done);
    void assemble(const std::shared_ptr<const PlaneStructure>& structure, std::unique_ptr<StaticSystem> numbered,
                  Solved& done);

    AnalysisOptions options_;
    std::shared_ptr<const PlaneStructure> structure_; ///< the last one, to whose elements the system refers
    std::unique_ptr<StaticSystem> system_;            ///< with its order; null at first
};

} // namespace femoop::plane
