#include "femoop/solver/symmetric_solver.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "femoop/solver/cholmod_solver.h"
#include "femoop/solver/elimination_plan.h"
#include "femoop/solver/ldlt_solver.h"
#include "femoop/solver/multifrontal/multifrontal_solver.h"
#include "femoop/solver/skyline_solver.h"

namespace femoop {

namespace {

/// Every unknown a block of its own, every entry of K a pair of blocks.
BlockGraph graph_of(const SparseMatrix& K)
{
    BlockGraph graph;
    graph.block_sizes.assign(static_cast<std::size_t>(K.cols()), 1);
    for (std::int32_t column = 0; column < K.cols(); ++column)
        for (SparseMatrix::InnerIterator entry(K, column); entry; ++entry)
            if (entry.row() > column) graph.add_clique(std::array{static_cast<std::int32_t>(entry.row()), column});
    return graph;
}

} // namespace

bool Pivots::note(std::int32_t equation, double pivot, double diagonal)
{
    is_positive_definite = pivot > 0.0; // also false for NaN
    const double ratio = is_positive_definite ? pivot / diagonal : 0.0;
    if (ratio < smallest_ratio || weakest == SystemPattern::none) {
        smallest_ratio = ratio;
        weakest = equation;
    }
    return is_positive_definite;
}

void Pivots::take(const Pivots& later)
{
    if (!is_positive_definite || later.weakest == SystemPattern::none) return;
    const bool is_weaker = weakest == SystemPattern::none || later.smallest_ratio < smallest_ratio;
    if (is_weaker || !later.is_positive_definite) *this = later;
}

void SymmetricSolver::analyse(const SystemPattern& pattern)
{
    to_order_.resize(0);
    if (pattern.n_equations() > 0) analyse_ordered({.column_start = pattern.column_start(), .rows = pattern.rows()});
}

void SymmetricSolver::analyse(const SparseMatrix& K, Ordering ordering)
{
    analyse(K, elimination_order(BlockAdjacency(graph_of(K)), ordering));
}

void SymmetricSolver::analyse(const SparseMatrix& K, const std::vector<std::int32_t>& order)
{
    if (K.cols() == 0) return;
    to_order_.resize(K.cols());
    for (std::size_t i = 0; i < order.size(); ++i) to_order_.indices()[order[i]] = static_cast<std::int32_t>(i);
    const SparseMatrix ordered = in_order(K);
    const auto n = static_cast<std::size_t>(ordered.cols());
    analyse_ordered({.column_start = std::span(ordered.outerIndexPtr(), n + 1),
                     .rows = std::span(ordered.innerIndexPtr(), static_cast<std::size_t>(ordered.nonZeros()))});
}

SparseMatrix SymmetricSolver::in_order(const SparseMatrix& K) const
{
    const SparseMatrix both = K.selfadjointView<Eigen::Lower>();
    SparseMatrix ordered(K.rows(), K.cols());
    ordered.selfadjointView<Eigen::Lower>() = both.selfadjointView<Eigen::Lower>().twistedBy(to_order_);
    // Transposed twice, the rows of each column come out ascending.
    return SparseMatrix(SparseMatrix(ordered.transpose()).transpose());
}

Pivots SymmetricSolver::factorize(const SparseMatrix& K)
{
    if (K.cols() == 0) return {};
    if (to_order_.size() == 0) return factorize_ordered(K);
    Pivots pivots = factorize_ordered(in_order(K));
    if (pivots.weakest != SystemPattern::none)
        pivots.weakest = Permutation(to_order_.inverse()).indices()[pivots.weakest];
    return pivots;
}

Eigen::MatrixXd SymmetricSolver::solve(const Eigen::MatrixXd& B) const
{
    if (B.size() == 0) return B;
    if (to_order_.size() == 0) return solve_ordered(B);
    return to_order_.inverse() * solve_ordered(to_order_ * B);
}

std::unique_ptr<SymmetricSolver> make_solver(SolverKind kind)
{
    std::unique_ptr<SymmetricSolver> solver;
    if (kind == SolverKind::Skyline) solver = std::make_unique<SkylineSolver>();
    if (kind == SolverKind::Multifrontal) solver = std::make_unique<MultifrontalSolver>();
    if (kind == SolverKind::Ldlt) solver = std::make_unique<LdltSolver>();
    if (kind == SolverKind::Cholmod) solver = make_cholmod_solver();
    if (!solver) throw std::invalid_argument("make_solver: there is no solver \"" + std::string(name(kind)) + '"');
    return solver;
}

std::unique_ptr<SymmetricSolver> solver_for(const SparseMatrix& K, SolverKind wanted)
{
    const BlockGraph graph = graph_of(K);
    const EliminationPlan plan = plan_elimination(wanted, graph, BlockAdjacency(graph));
    std::unique_ptr<SymmetricSolver> solver = make_solver(plan.solver);
    solver->analyse(K, plan.order);
    return solver;
}

} // namespace femoop
