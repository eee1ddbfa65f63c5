#include "femoop/analysis/precise_system.h"

namespace femoop {

namespace {

/// T' A T of a symmetric A, both as lower triangles.
PreciseSparseMatrix reduced(const PreciseSparseMatrix& A, const PreciseSparseMatrix& T)
{
    const PreciseSparseMatrix whole = A.selfadjointView<Eigen::Lower>();
    return PreciseSparseMatrix(PreciseSparseMatrix(T.transpose()) * PreciseSparseMatrix(whole * T))
        .triangularView<Eigen::Lower>();
}

} // namespace

PreciseSystem::PreciseSystem(const Part& elastic)
    : K_(elastic.K), solver_(std::make_unique<PreciseSolver>(K_, elastic.rough))
{}

PreciseSystem::PreciseSystem(const Part& elastic, const Part& own, const Sparse& T, const Sparse& S)
    : K_(elastic.K),
      own_(own.K),
      T_(T.cast<DoubleDouble>()),
      S_(S.cast<DoubleDouble>()),
      solver_(std::make_unique<PreciseSolver>(reduced(K_, T_), elastic.rough)),
      own_solver_(std::make_unique<PreciseSolver>(reduced(own_, S_), own.rough))
{}

std::optional<PreciseSystem::Displacements> PreciseSystem::solve(const PreciseMatrix& F, const Eigen::MatrixXd& x0)
{
    const auto K = K_.selfadjointView<Eigen::Lower>();
    Displacements u;
    if (!own_solver_) {
        auto x = solver_->solve(F);
        if (!x) return std::nullopt;
        u.all = std::move(*x);
    } else {
        u.all = x0.cast<DoubleDouble>();
        const auto y = solver_->solve(T_.transpose() * PreciseMatrix(F - K * u.all));
        if (!y) return std::nullopt;
        u.all += T_ * *y;
    }
    PreciseMatrix residual = F - K * u.all;
    if (own_solver_) {
        const auto z = own_solver_->solve(S_.transpose() * residual);
        if (!z) return std::nullopt;
        u.constraint = S_ * *z;
        residual -= own_.selfadjointView<Eigen::Lower>() * u.constraint;
    }
    u.out_of_balance = Eigen::VectorXd::Zero(F.cols());
    if (F.rows() > 0) u.out_of_balance = rounded(residual).cwiseAbs().colwise().maxCoeff().transpose();
    return u;
}

} // namespace femoop
