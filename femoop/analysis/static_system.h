#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <vector>

#include "femoop/analysis/analysis_options.h"
#include "femoop/analysis/assembler.h"
#include "femoop/analysis/elimination.h"
#include "femoop/analysis/precise_system.h"
#include "femoop/analysis/reduced_system.h"
#include "femoop/analysis/unrestrained_rotation.h"
#include "femoop/discretisation/solution.h"

namespace femoop {

/// The static equations K u = f of a structure: numbered and assembled once, factored once for all loads.
///
/// Whether the equations can be trusted is not its affair: who solves them looks at the pivots and, where these are
/// small, at femoop/analysis/mechanism_report.h.
class StaticSystem {
public:
    StaticSystem(std::shared_ptr<const Discretisation> structure, SolverKind wanted); ///< numbers the equations
    StaticSystem(const StaticSystem&) = delete;
    StaticSystem& operator=(const StaticSystem&) = delete;

    void assemble(); ///< K, with artificial restraints where nothing takes part in a rotation
    /// Takes on other numbers and assembles them; what is symbolic stays. \pre prepare, have_same_equations
    void update(std::shared_ptr<const Discretisation> structure);
    /// Assembles, and does the symbolic work of the solver, at the same time where there is enough of both. Seconds are
    /// added to the statistics. \throws InsufficientMemory, once assembled
    void prepare(const AnalysisOptions& options, AnalysisStatistics& statistics);
    Pivots factorize() { return reduced_->factorize(); }  ///< \pre prepare
    void note_size(AnalysisStatistics& statistics) const; ///< and who solves. \pre prepare

    const std::shared_ptr<const Discretisation>& structure() const { return structure_; }
    const Equations& equations() const { return equations_; }
    const Assembler& assembler() const { return *assembler_; }
    const ArtificialRestraints& restraints() const { return restraints_; }
    const ReducedSystem& reduced() const { return *reduced_; } ///< \pre assemble
    /// Has it an unknown with no more stiffness than rounding of an element leaves? Its pivot tells nothing.
    bool has_unrestrained_unknown() const { return reduced_->has_unrestrained_unknown(largest_stiffness_); }

    Eigen::MatrixXd load_vectors(const std::vector<CaseLoads>& loads) const; ///< [unknowns x cases]

    /// What constraints, settlements and heat impose on the unknowns [unknowns x cases], or the conflicts among them;
    /// empty without constraints.
    Elimination imposed(const std::vector<CaseLoads>& loads) const;

    /// \pre factorize. `x0` is what is imposed; not looked at without constraints.
    ReducedSystem::Displacements solve(const Eigen::MatrixXd& F, const Eigen::MatrixXd& x0);
    /// The same as the structure moves, case by case, with the largest force left out of balance.
    std::vector<detail::CaseSolution> solutions(const std::vector<CaseLoads>& loads, const Eigen::MatrixXd& F,
                                                const ReducedSystem::Displacements& u) const;

    /// To 32 digits; nothing where even they are too few.
    std::vector<detail::CaseSolution> solve_precisely(const std::vector<CaseLoads>& loads, const Eigen::MatrixXd& x0);

    /// How the structure moves when its unknowns do, supports at rest: a mode, a mechanism.
    detail::CaseSolution motion(const Eigen::VectorXd& x) const;

private:
    template <class Scalar> using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
    template <class Scalar> using Column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

    PreciseSystem& precise();
    template <class Scalar> Dense<Scalar> load_vectors_of(const std::vector<CaseLoads>& loads) const;
    double imposed_force(CaseLoads loads) const;
    template <class Scalar>
    detail::Motions<Scalar> motions(const CaseLoads& loads, const Column<Scalar>& all,
                                    const Column<Scalar>& constraint) const;
    template <class Scalar>
    std::vector<Scalar> node_displacements(const Column<Scalar>& x, const std::vector<double>& settlements) const;
    template <class Scalar> std::vector<Scalar> member_ends(const Column<Scalar>& x) const;

    SparseMatrix stiffness(); ///< with the restraints that it needs

    std::shared_ptr<const Discretisation> structure_;
    std::optional<Elements> elements_;
    Equations equations_;
    std::optional<Assembler> assembler_;
    double largest_stiffness_ = 0.0; ///< of an element against one of its displacements
    ArtificialRestraints restraints_;
    std::optional<ReducedSystem> reduced_;
    std::optional<PreciseSystem> precise_; ///< made when it is first asked for
};

} // namespace femoop
