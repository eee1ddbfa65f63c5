#pragma once

#include <optional>
#include <vector>

#include "femoop/methods/derivation/derivation.h"
#include "femoop/methods/derivation/paper_system.h"

namespace femoop::derivation {

/// The equations of a structure step by step, as far as these rows of the unknowns are concerned.
class SystemSteps {
public:
    /// \param about  a step that says which member or node the rows belong to
    SystemSteps(const PaperSystem& system, std::vector<Eigen::Index> rows, Step about);

    /// What does not depend on loads: what ties the displacements, and in which order they are numbered.
    std::vector<Step> order() const;
    /// From the loads to the displacements.
    std::vector<Step> solved(CaseId load_case, const CaseResult& result) const;
    /// What the ties carry; none without ties.
    std::vector<Step> tie_forces(CaseId load_case, const CaseResult& result) const;
    Step equations(CaseId load_case, const CaseResult& result) const;
    /// A displacement that follows others; nothing where it is one that is solved for.
    std::optional<Step> tied_displacement(Eigen::Index row, CaseId load_case, const CaseResult& result) const;

private:
    Step step(StepKind kind, std::optional<CaseId> load_case, std::vector<NamedMatrix> matrices) const;
    Step ties() const;
    Step numbering() const;
    Step right_hand_side(CaseId load_case) const;
    std::optional<Step> imposed(CaseId load_case) const;
    std::vector<Eigen::Index> tying_rows() const; ///< of C, that have terms here

    const PaperSystem& system_;
    std::vector<Eigen::Index> rows_;
    Step about_;
};

} // namespace femoop::derivation
