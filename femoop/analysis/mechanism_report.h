#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "femoop/analysis/mechanism.h"
#include "femoop/analysis/member_mechanism.h"
#include "femoop/analysis/static_system.h"
#include "femoop/model/fault/fault.h"
#include "femoop/model/model.h"

namespace femoop {

/// Why a static system cannot be solved, or not well: it looks at what the equations leave free and says it of the
/// model's parts. It changes no equation.
class MechanismReport {
public:
    /// \pre the system is assembled, and lives as long as the report
    MechanismReport(const Model& model, const StaticSystem& system);

    /// Refuses a structure that can move, or whose stiffness is beyond the range of numbers; then what the pivots say
    /// is the fault of soft parts only. Small pivots may come from either: the geometry alone decides, and nothing does
    /// where a member is so short that numbers cannot tell.
    /// \throws MechanismError, ModelError
    void require_geometric_stability() const;

    /// Refuses members that their own releases leave free, which no equation shows. \throws MechanismError
    void require_held_members() const;

    /// Refuses loads that drive what is restrained artificially. \throws MechanismError
    void require_undriven(const std::vector<CaseLoads>& loads, const Eigen::MatrixXd& F) const;

    /// Refuses constraints that contradict one another, or what is imposed. \throws ModelError
    void require_compatible(const Elimination& imposed) const;

    /// Refuses numbers of a load case that are beyond the range, [unknowns x cases]. \throws ModelError
    void require_finite(const Eigen::MatrixXd& values) const;

    /// Fewer forces than equations: something moves, whatever the pivots say.
    bool has_too_few_members() const;

    struct SoftParts {
        Fault warning;
        bool is_nearly_loose; ///< soft beside every other part, not only beside some very stiff one
    };
    /// Warns of the parts that are soft beside the rest; nothing if no condition can be estimated.
    std::optional<SoftParts> soft_parts() const;

private:
    void require_finite_stiffness() const;
    bool has_finite_stiffness(NodeId node) const;
    bool has_vanishing_member() const; ///< beside which nothing can be told of how the others strain
    /// Of each kind the first are described, the others counted.
    struct Found {
        std::vector<Mechanism> mechanisms;
        std::size_t n_more = 0;
    };
    [[noreturn]] void refuse(const Eigen::MatrixXd& modes) const;
    void add_motions(const Eigen::MatrixXd& modes, Found& found) const;
    void add_members(const std::vector<LooseMember>& members, Found& found) const;
    void add_driven(const std::vector<CaseLoads>& loads, const Eigen::MatrixXd& F, Found& found) const;

    const Model& model_;
    const StaticSystem& system_;
    const Discretisation& structure_;
};

} // namespace femoop
