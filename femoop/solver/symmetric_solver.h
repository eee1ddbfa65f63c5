#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include "femoop/solver/elimination_plan.h"
#include "femoop/solver/solver_options.h"
#include "femoop/solver/system_pattern.h"

namespace femoop {

/// Which signs the pivots of a matrix may have.
enum class Signs : std::uint8_t {
    Positive, ///< all are positive: elimination stops at the first that is not
    Any       ///< K may be indefinite, as shifted ones are: K - s M
};

/// How a factorization K = L D L' went.
struct Pivots {
    bool is_complete = true; ///< if not, elimination stopped at `weakest` and there is no solution
    bool is_positive_definite = true;
    /// Of how many pivots the sign is negative: as many eigenvalues of K lie below zero (Sylvester's law of inertia),
    /// so that K - s M has as many as K u = w M u has eigenvalues w below s (Sturm).
    std::int32_t n_negative = 0;
    /// The smallest |d_i| / K_ii: what is left of a diagonal entry once all before it is eliminated. 1 where nothing
    /// couples; near rounding (1e-16 times a modest number) where the structure may move freely. 0 when it broke down.
    /// For Signs::Any beside the largest entry of the row in place of K_ii.
    double smallest_ratio = 1.0;
    std::int32_t weakest = SystemPattern::none; ///< equation of the smallest ratio

    /// Takes note of a pivot; false if elimination must stop.
    bool note(std::int32_t equation, double pivot, double reference, Signs signs = Signs::Positive);
    /// Takes note of what was eliminated after this, independent of it.
    void include(const Pivots& later);
};

/// Solves K x = b for a symmetric sparse K, in three steps that can be repeated from any of them: a new pattern, new
/// numbers, new right-hand sides.
///
///     auto solver = make_solver(kind);
///     solver->analyse(pattern);                            // symbolic, kept while the pattern stays
///     if (solver->factorize(K).is_complete) X = solver->solve(B);
///
/// A solver of another kind derives from this and works in the order of elimination only.
class SymmetricSolver {
public:
    virtual ~SymmetricSolver() = default;
    SymmetricSolver(const SymmetricSolver&) = delete;
    SymmetricSolver& operator=(const SymmetricSolver&) = delete;

    /// Symbolic analysis of matrices of a pattern, which is in the order of elimination already.
    /// \throws InsufficientMemory
    void analyse(const SystemPattern& pattern);
    /// Symbolic analysis of matrices that have their nonzeros where K (lower triangle) has; finds an order of
    /// elimination and keeps it to itself.
    void analyse(const SparseMatrix& K, Ordering ordering = Ordering::MinimumDegree);

    /// \pre K has the pattern of the last analysis.
    /// \throws Cancelled
    /// \throws std::invalid_argument for Signs::Any if the solver is CHOLMOD's, whose L L' has roots of pivots.
    Pivots factorize(const SparseMatrix& K, Signs signs = Signs::Positive);

    /// One column per right-hand side. \pre the last factorization is complete.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;

    /// Who hears how far a factorization is, and may cancel it; none if empty. The multifrontal solver asks between
    /// fronts, others at the beginning and at the end. After Cancelled the solver is as after its analysis.
    void set_progress(Progress progress) { progress_ = std::move(progress); }
    /// Bytes that a factorization may take, what the machine has free if empty. The multifrontal solver throws
    /// InsufficientMemory when it analyses what would take more.
    void set_memory_limit(std::optional<double> bytes) { memory_limit_ = bytes; }

    virtual std::size_t factor_nonzeros() const = 0; ///< entries kept of L, diagonal included
    /// What a factorization will cost, known after the analysis; 0 where the solver does not tell.
    virtual double predicted_operations() const { return 0.0; } ///< multiplications with additions
    virtual double predicted_bytes() const { return 0.0; }
    virtual std::string_view name() const = 0; ///< as `--solver` takes it

protected:
    SymmetricSolver() = default;

    const Progress& progress() const { return progress_; }
    double memory_limit() const; ///< bytes: what was set, or what is free

    /// What each pivot is held against: the diagonal of K, or the largest of each row where signs may be any.
    static Eigen::VectorXd references(const SparseMatrix& K, Signs signs);

    /// A lower triangle by columns, in the order of elimination.
    struct Pattern {
        std::span<const std::int32_t> column_start; ///< [equations + 1]
        std::span<const std::int32_t> rows;         ///< ascending in each column, the diagonal first
        std::size_t n() const { return column_start.size() - 1; }
    };

private:
    friend std::unique_ptr<SymmetricSolver> solver_for(const SparseMatrix& K, const SolverOptions& options);
    void analyse(const SparseMatrix& K, const std::vector<std::int32_t>& order);
    virtual void analyse_ordered(Pattern pattern) = 0;
    virtual Pivots factorize_ordered(const SparseMatrix& K, Signs signs) = 0;
    virtual Eigen::MatrixXd solve_ordered(Eigen::MatrixXd B) const = 0;

    SparseMatrix in_order(const SparseMatrix& K) const;
    void tell(double share) const;

    using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, std::int32_t>;
    Permutation to_order_; ///< given order to that of elimination; empty where they are the same
    Progress progress_;
    std::optional<double> memory_limit_;
};

/// A solver of a kind. \throws std::invalid_argument for Automatic (see SystemPattern::solver and solver_for) and for a
/// kind that the library is built without.
std::unique_ptr<SymmetricSolver> make_solver(const SolverOptions& options);

/// Who solves such a system (lower triangle) fastest, and in which order: `solver_for` takes it.
EliminationPlan plan_elimination(SolverKind wanted, const SparseMatrix& K);

/// A solver with the symbolic analysis of matrices that have their nonzeros where K (lower triangle) has.
std::unique_ptr<SymmetricSolver> solver_for(const SparseMatrix& K, const SolverOptions& options = {});

} // namespace femoop
