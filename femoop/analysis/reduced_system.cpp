#include "femoop/analysis/reduced_system.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "femoop/solver/refinement.h"

namespace femoop {

namespace {

constexpr double cancelled = 1e-11; // of the terms that were added up: less may be rounding alone
constexpr double turned = 1e-13;    // of the largest stiffness: less may be what turning into a node's axes has rounded

/// T' A T of a symmetric A, both as lower triangles.
SparseMatrix reduced(const SparseMatrix& A, const SparseMatrix& T)
{
    const SparseMatrix whole = A.selfadjointView<Eigen::Lower>();
    return SparseMatrix(T.transpose() * whole * T).triangularView<Eigen::Lower>();
}

SparseMatrix picking(const std::vector<std::int32_t>& unknowns, Eigen::Index n_unknowns)
{
    std::vector<Eigen::Triplet<double>> ones;
    for (std::size_t i = 0; i < unknowns.size(); ++i) ones.emplace_back(unknowns[i], static_cast<int>(i), 1.0);
    SparseMatrix S(n_unknowns, static_cast<Eigen::Index>(unknowns.size()));
    S.setFromTriplets(ones.begin(), ones.end());
    return S;
}

} // namespace

ReducedSystem::ReducedSystem(const Equations& equations, SparseMatrix&& K) : equations_(equations) { K_.swap(K); }

void ReducedSystem::constrain(const Elimination& elimination, SparseMatrix&& own)
{
    is_constrained_ = true;
    own_.swap(own);
    T_ = elimination.T;
    S_ = picking(elimination.dependent, K_.rows());
    K_reduced_ = reduced(K_, T_);
    const SparseMatrix T = T_.cwiseAbs(), magnitudes = SparseMatrix(K_.cwiseAbs()).selfadjointView<Eigen::Lower>();
    terms_ = T.cwiseProduct(magnitudes * T).transpose() * Eigen::VectorXd::Ones(T.rows());
}

void ReducedSystem::analyse(const AnalysisOptions& options)
{
    options_ = options;
    if (is_constrained_) {
        if (K_reduced_.rows() == 0) return;
        solver_ = solver_for(K_reduced_, options.solver);
        return;
    }
    if (equations_.n_unknowns() == 0) return;
    SolverOptions chosen = options.solver;
    chosen.kind = equations_.pattern().solver();
    solver_ = make_solver(chosen);
    solver_->analyse(equations_.pattern());
}

void ReducedSystem::update(SparseMatrix&& K)
{
    K_.swap(K);
    is_factored_ = false;
}

Pivots ReducedSystem::factorize()
{
    if (S_.cols() > 0) factorize_own();
    const Pivots pivots = solver_ ? solver_->factorize(matrix()) : Pivots{};
    is_factored_ = pivots.is_complete;
    return pivots;
}

void ReducedSystem::factorize_own()
{
    const SparseMatrix picked = reduced(own_, S_);
    own_solver_ = solver_for(picked, options_.solver);
    own_solver_->factorize(picked);
}

bool ReducedSystem::has_unrestrained_unknown(double largest_stiffness) const
{
    const Eigen::VectorXd diagonal = matrix().diagonal();
    if (diagonal.size() == 0) return false;
    if (diagonal.minCoeff() <= turned * std::max(largest_stiffness, diagonal.maxCoeff())) return true;
    return is_constrained_ && (diagonal.array() <= cancelled * terms_.array()).any();
}

double ReducedSystem::condition() const { return condition_estimate(*solver_, matrix()); }

ReducedSystem::SoftMotion ReducedSystem::softest_motion() const
{
    constexpr double zero_eigenvalue = 1e-14; // what is less may be rounding alone
    constexpr Eigen::Index one = 1;
    const NullModes soft = null_modes(matrix(), zero_eigenvalue, one);
    const Eigen::VectorXd x = soft.is_singular() ? soft.modes.col(0) : soft.softest;
    const double condition = soft.is_singular() && is_factored_ ? this->condition() : soft.condition;
    const double energy = x.dot(matrix().selfadjointView<Eigen::Lower>() * x) / x.squaredNorm();
    const double stiffness = std::abs(energy) / matrix().diagonal().minCoeff();
    return {.x = is_constrained_ ? Eigen::VectorXd(T_ * x) : x, .condition = condition, .stiffness = stiffness};
}

Eigen::MatrixXd ReducedSystem::solved(const Eigen::MatrixXd& B)
{
    if (!options_.is_refined) return solver_->solve(B);
    RefinedSolution solution = solve_refined(*solver_, matrix(), B);
    backward_error_ = solution.backward_error;
    refinements_ = solution.n_steps;
    return std::move(solution.X);
}

ReducedSystem::Displacements ReducedSystem::solve(const Eigen::MatrixXd& F)
{
    return {.all = solver_ ? solved(F) : F, .constraint = {}};
}

ReducedSystem::Displacements ReducedSystem::solve(const Eigen::MatrixXd& F, const Eigen::MatrixXd& x0)
{
    const auto K = K_.selfadjointView<Eigen::Lower>();
    const Eigen::MatrixXd load = T_.transpose() * (F - K * x0);
    Displacements u{.all = x0, .constraint = Eigen::MatrixXd::Zero(F.rows(), F.cols())};
    if (solver_) u.all += T_ * solved(load);
    if (!own_solver_) return u;
    const Eigen::MatrixXd out_of_balance = F - K * u.all;
    u.constraint = S_ * own_solver_->solve(S_.transpose() * out_of_balance);
    return u;
}

Eigen::VectorXd ReducedSystem::out_of_balance(const Eigen::MatrixXd& F, const Displacements& u) const
{
    if (F.rows() == 0) return Eigen::VectorXd::Zero(F.cols());
    Eigen::MatrixXd residual = F - K_.selfadjointView<Eigen::Lower>() * u.all;
    if (is_constrained_) residual -= own_.selfadjointView<Eigen::Lower>() * u.constraint;
    return residual.cwiseAbs().colwise().maxCoeff().transpose();
}

PreciseSystem ReducedSystem::precise(PreciseSparseMatrix&& K, PreciseSparseMatrix&& own) const
{
    const PreciseSystem::Part elastic{.K = K, .rough = is_factored_ ? solver_.get() : nullptr};
    if (!is_constrained_) return PreciseSystem(elastic);
    return {elastic, {.K = own, .rough = own_solver_.get()}, T_, S_};
}

} // namespace femoop
