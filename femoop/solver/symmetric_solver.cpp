#include "femoop/solver/symmetric_solver.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "femoop/solver/available_memory.h"
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

bool Pivots::note(std::int32_t equation, double pivot, double reference, Signs signs)
{
    const bool is_positive = pivot > 0.0; // also false for NaN
    is_positive_definite = is_positive_definite && is_positive;
    is_complete = is_positive || (signs == Signs::Any && std::isfinite(pivot) && pivot != 0.0);
    if (pivot < 0.0) ++n_negative;
    const double ratio = is_complete ? std::abs(pivot) / reference : 0.0;
    if (ratio < smallest_ratio || weakest == SystemPattern::none) {
        smallest_ratio = ratio;
        weakest = equation;
    }
    return is_complete;
}

void Pivots::include(const Pivots& later)
{
    if (!is_complete || later.weakest == SystemPattern::none) return;
    is_complete = later.is_complete;
    is_positive_definite = is_positive_definite && later.is_positive_definite;
    n_negative += later.n_negative;
    if (weakest != SystemPattern::none && smallest_ratio <= later.smallest_ratio && is_complete) return;
    smallest_ratio = later.smallest_ratio;
    weakest = later.weakest;
}

Eigen::VectorXd SymmetricSolver::references(const SparseMatrix& K, Signs signs)
{
    Eigen::VectorXd largest = K.diagonal().cwiseAbs();
    if (signs == Signs::Positive) return largest;
    for (std::int32_t column = 0; column < K.cols(); ++column)
        for (SparseMatrix::InnerIterator entry(K, column); entry; ++entry)
            for (const Eigen::Index i : {entry.row(), entry.col()})
                largest[i] = std::max(largest[i], std::abs(entry.value()));
    return largest;
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

double SymmetricSolver::memory_limit() const { return memory_limit_.value_or(available_memory()); }

SparseMatrix SymmetricSolver::in_order(const SparseMatrix& K) const
{
    const SparseMatrix both = K.selfadjointView<Eigen::Lower>();
    SparseMatrix ordered(K.rows(), K.cols());
    ordered.selfadjointView<Eigen::Lower>() = both.selfadjointView<Eigen::Lower>().twistedBy(to_order_);
    // Transposed twice, the rows of each column come out ascending.
    return SparseMatrix(SparseMatrix(ordered.transpose()).transpose());
}

Pivots SymmetricSolver::factorize(const SparseMatrix& K, Signs signs)
{
    if (K.cols() == 0) return {};
    const bool is_in_order = to_order_.size() == 0;
    tell(0.0);
    Pivots pivots = is_in_order ? factorize_ordered(K, signs) : factorize_ordered(in_order(K), signs);
    tell(1.0);
    if (!is_in_order && pivots.weakest != SystemPattern::none)
        pivots.weakest = Permutation(to_order_.inverse()).indices()[pivots.weakest];
    return pivots;
}

void SymmetricSolver::tell(double share) const
{
    if (progress_ && !progress_(share)) throw Cancelled();
}

Eigen::MatrixXd SymmetricSolver::solve(const Eigen::MatrixXd& B) const
{
    if (B.size() == 0) return B;
    if (to_order_.size() == 0) return solve_ordered(B);
    return to_order_.inverse() * solve_ordered(to_order_ * B);
}

std::unique_ptr<SymmetricSolver> make_solver(const SolverOptions& options)
{
    const SolverKind kind = options.kind;
    std::unique_ptr<SymmetricSolver> solver;
    if (kind == SolverKind::Skyline) solver = std::make_unique<SkylineSolver>();
    if (kind == SolverKind::Multifrontal) solver = std::make_unique<MultifrontalSolver>();
    if (kind == SolverKind::Ldlt) solver = std::make_unique<LdltSolver>();
    if (kind == SolverKind::Cholmod) solver = make_cholmod_solver();
    if (!solver) throw std::invalid_argument("make_solver: there is no solver \"" + std::string(name(kind)) + '"');
    solver->set_progress(options.progress);
    solver->set_memory_limit(options.memory_limit);
    return solver;
}

EliminationPlan plan_elimination(SolverKind wanted, const SparseMatrix& K)
{
    const BlockGraph graph = graph_of(K);
    return plan_elimination(wanted, graph, BlockAdjacency(graph));
}

std::unique_ptr<SymmetricSolver> solver_for(const SparseMatrix& K, const SolverOptions& options)
{
    const EliminationPlan plan = plan_elimination(options.kind, K);
    SolverOptions chosen = options;
    chosen.kind = plan.solver;
    std::unique_ptr<SymmetricSolver> solver = make_solver(chosen);
    solver->analyse(K, plan.order);
    return solver;
}

} // namespace femoop
