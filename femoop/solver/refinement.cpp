#include "femoop/solver/refinement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace femoop {

namespace {

/// |K| X of a lower triangle, with X >= 0.
Eigen::MatrixXd times_magnitudes(const SparseMatrix& K, const Eigen::MatrixXd& X)
{
    Eigen::MatrixXd Y = Eigen::MatrixXd::Zero(X.rows(), X.cols());
    for (Eigen::Index column = 0; column < K.cols(); ++column)
        for (SparseMatrix::InnerIterator entry(K, column); entry; ++entry) {
            Y.row(entry.row()) += std::abs(entry.value()) * X.row(column);
            if (entry.row() != column) Y.row(column) += std::abs(entry.value()) * X.row(entry.row());
        }
    return Y;
}

double backward_error(const SparseMatrix& K, const Eigen::MatrixXd& X, const Eigen::MatrixXd& B,
                      const Eigen::MatrixXd& residual)
{
    const Eigen::MatrixXd scale = times_magnitudes(K, X.cwiseAbs()) + B.cwiseAbs();
    double largest = 0.0;
    for (Eigen::Index i = 0; i < scale.size(); ++i)
        if (scale.data()[i] > 0.0) largest = std::max(largest, std::abs(residual.data()[i]) / scale.data()[i]);
    return largest;
}

} // namespace

RefinedSolution solve_refined(const SymmetricSolver& solver, const SparseMatrix& K, const Eigen::MatrixXd& B)
{
    constexpr int most_steps = 10;
    constexpr double rounding = std::numeric_limits<double>::epsilon();
    RefinedSolution best{.X = solver.solve(B)};
    Eigen::MatrixXd residual = B - K.selfadjointView<Eigen::Lower>() * best.X;
    best.backward_error = backward_error(K, best.X, B, residual);
    while (best.n_steps < most_steps && best.backward_error > rounding) {
        Eigen::MatrixXd X = best.X + solver.solve(residual);
        residual = B - K.selfadjointView<Eigen::Lower>() * X;
        const double error = backward_error(K, X, B, residual);
        if (!(error <= 0.5 * best.backward_error)) break;
        best = {.X = std::move(X), .backward_error = error, .n_steps = best.n_steps + 1};
    }
    return best;
}

} // namespace femoop
