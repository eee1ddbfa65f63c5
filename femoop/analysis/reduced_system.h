#pragma once

#include <Eigen/Core>
#include <memory>

#include "femoop/analysis/analysis_options.h"
#include "femoop/analysis/elimination.h"
#include "femoop/analysis/precise_system.h"
#include "femoop/discretisation/equations.h"
#include "femoop/solver/null_modes.h"
#include "femoop/solver/symmetric_solver.h"

namespace femoop {

/// K x = F of a structure, where constraints may make some unknowns follow the others:
///
///     x = T y + x0        T' K T y = T' (F - K x0)        without constraints T = 1, x0 = 0
///
/// K is elastic: what constraints take from members is not in it. The forces that the constraints carry are what F and
/// K x leave out of balance at the unknowns that follow; they go to the constrained members in proportion to their own
/// stiffness, the limit of EA and EI that grow together.
///
/// What is handed over is swapped in: Eigen copies a sparse matrix that is moved.
class ReducedSystem {
public:
    /// Of all unknowns of the equations, with no numbers yet.
    explicit ReducedSystem(const Equations& equations) : equations_(equations) {}
    /// \pre K is their lower triangle and has their pattern.
    ReducedSystem(const Equations& equations, SparseMatrix&& K);

    /// Leaves only the independent unknowns. `own` is what the constraints take from members, over all unknowns.
    void constrain(const Elimination& elimination, SparseMatrix&& own);

    void analyse(const AnalysisOptions& options); ///< symbolic; without constraints it asks for no numbers
    void update(SparseMatrix&& K);                ///< other numbers, to be factored. \pre no constraints, analyse
    Pivots factorize();                           ///< \pre analyse
    /// The system that is factored; nothing where no unknown is left.
    const SparseMatrix& matrix() const { return is_constrained_ ? K_reduced_ : K_; }
    const SymmetricSolver* solver() const { return solver_.get(); }

    const SparseMatrix& stiffness() const { return K_; } ///< elastic, over all unknowns, lower triangle
    /// One with no more stiffness than cos(90 degrees) leaves of the largest of an element: its pivot tells nothing.
    bool has_unrestrained_unknown(double largest_stiffness) const;
    double condition() const; ///< estimate. \pre a factorization that did not break down
    struct SoftMotion {
        Eigen::VectorXd x; ///< over all unknowns, largest entry 1
        double condition;  ///< estimate; infinite if the factorization broke down
        double stiffness;  ///< against it, of the least that any unknown alone has; rounding may raise it
    };
    SoftMotion softest_motion() const; ///< as far as rounding in K lets see

    struct Displacements {
        Eigen::MatrixXd all;        ///< [unknowns x cases]
        Eigen::MatrixXd constraint; ///< what forces in constrained members follow from; empty without constraints
    };
    Displacements solve(const Eigen::MatrixXd& F);
    Displacements solve(const Eigen::MatrixXd& F, const Eigen::MatrixXd& x0); ///< \pre it is constrained
    /// How good the last solution is and what that took; of no worth unless options.is_refined.
    double backward_error() const { return backward_error_; }
    int refinements() const { return refinements_; }

    /// The largest force out of balance, of every load case.
    Eigen::VectorXd out_of_balance(const Eigen::MatrixXd& F, const Displacements& u) const;

    /// The same system from stiffnesses of 32 digits, to be used while this one lives.
    PreciseSystem precise(PreciseSparseMatrix&& K, PreciseSparseMatrix&& own) const;

private:
    void factorize_own();
    Eigen::MatrixXd solved(const Eigen::MatrixXd& B);

    const Equations& equations_;
    SparseMatrix K_, K_reduced_;
    SparseMatrix own_;
    SparseMatrix T_;        ///< all unknowns from the independent
    SparseMatrix S_;        ///< all unknowns from the dependent
    Eigen::VectorXd terms_; ///< magnitudes that add up to the diagonal of the constrained system
    bool is_constrained_ = false;
    bool is_factored_ = false;
    AnalysisOptions options_;
    double backward_error_ = 0.0;
    int refinements_ = 0;
    std::unique_ptr<SymmetricSolver> solver_, own_solver_;
};

} // namespace femoop
