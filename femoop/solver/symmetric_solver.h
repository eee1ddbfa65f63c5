#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "femoop/solver/solver_kind.h"
#include "femoop/solver/system_pattern.h"

namespace femoop {

/// How a factorization K = L D L' went.
struct Pivots {
    bool is_positive_definite = true; ///< if not, elimination stopped at `weakest` and there is no solution
    /// The smallest d_i / K_ii: what is left of a diagonal entry once all before it is eliminated. 1 where nothing
    /// couples; near rounding (1e-16 times a modest number) where the structure may move freely. 0 when it broke down.
    double smallest_ratio = 1.0;
    std::int32_t weakest = SystemPattern::none; ///< equation of the smallest ratio

    /// Takes note of a pivot; false if it is not positive, and elimination must stop.
    bool note(std::int32_t equation, double pivot, double diagonal);
    /// Takes note of what was eliminated after this, independent of it.
    void take(const Pivots& later);
};

/// Solves K x = b for a symmetric positive definite sparse K, in three steps that can be repeated from any of them:
/// a new pattern, new numbers, new right-hand sides.
///
///     auto solver = make_solver(kind);
///     solver->analyse(pattern);                            // symbolic, kept while the pattern stays
///     if (solver->factorize(K).is_positive_definite) X = solver->solve(B);
///
/// A solver of another kind derives from this and works in the order of elimination only.
class SymmetricSolver {
public:
    virtual ~SymmetricSolver() = default;
    SymmetricSolver(const SymmetricSolver&) = delete;
    SymmetricSolver& operator=(const SymmetricSolver&) = delete;

    /// Symbolic analysis of matrices of a pattern, which is in the order of elimination already.
    void analyse(const SystemPattern& pattern);
    /// Symbolic analysis of matrices that have their nonzeros where K (lower triangle) has; finds an order of
    /// elimination and keeps it to itself.
    void analyse(const SparseMatrix& K, Ordering ordering = Ordering::MinimumDegree);

    /// \pre K has the pattern of the last analysis.
    Pivots factorize(const SparseMatrix& K);

    /// One column per right-hand side. \pre the last factorization was positive definite.
    Eigen::MatrixXd solve(const Eigen::MatrixXd& B) const;

    virtual std::size_t factor_nonzeros() const = 0; ///< entries kept of L, diagonal included
    virtual std::string_view name() const = 0;       ///< as `--solver` takes it

protected:
    SymmetricSolver() = default;

    /// A lower triangle by columns, in the order of elimination.
    struct Pattern {
        std::span<const std::int32_t> column_start; ///< [equations + 1]
        std::span<const std::int32_t> rows;         ///< ascending in each column, the diagonal first
        std::size_t n() const { return column_start.size() - 1; }
    };

private:
    friend std::unique_ptr<SymmetricSolver> solver_for(const SparseMatrix& K, SolverKind wanted);
    void analyse(const SparseMatrix& K, const std::vector<std::int32_t>& order);
    virtual void analyse_ordered(Pattern pattern) = 0;
    virtual Pivots factorize_ordered(const SparseMatrix& K) = 0;
    virtual Eigen::MatrixXd solve_ordered(Eigen::MatrixXd B) const = 0;

    SparseMatrix in_order(const SparseMatrix& K) const;

    using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, std::int32_t>;
    Permutation to_order_; ///< given order to that of elimination; empty where they are the same
};

/// A solver of a kind. \throws std::invalid_argument for Automatic (see SystemPattern::solver and solver_for) and for a
/// kind that the library is built without.
std::unique_ptr<SymmetricSolver> make_solver(SolverKind kind);

/// A solver with the symbolic analysis of matrices that have their nonzeros where K (lower triangle) has.
std::unique_ptr<SymmetricSolver> solver_for(const SparseMatrix& K, SolverKind wanted = SolverKind::Automatic);

} // namespace femoop
