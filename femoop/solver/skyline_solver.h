#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "femoop/solver/symmetric_solver.h"

namespace femoop {

/// L D L' inside the profile: of each row what lies between its first nonzero and the diagonal, one after the other.
///
///     x
///     x x          Fill stays inside the profile, so there is nothing symbolic to do but to find each row's first
///       x x        nonzero: for some hundred equations, numbered in a narrow profile, nothing is faster.
///       x . x
///           x x
///
/// Source  [Bathe1996, sec. 8.2.3]
class SkylineSolver final : public SymmetricSolver {
public:
    std::size_t factor_nonzeros() const override { return entries_.size() + d_.size(); }
    std::string_view name() const override { return "skyline"; }

private:
    void analyse_ordered(Pattern pattern) override;
    Pivots factorize_ordered(const SparseMatrix& K, Signs signs) override;
    Eigen::MatrixXd solve_ordered(Eigen::MatrixXd B) const override;

    using Row = Eigen::Map<Eigen::VectorXd>;
    using ConstRow = Eigen::Map<const Eigen::VectorXd>;
    void load(const SparseMatrix& K);
    double eliminate(std::size_t i);

    std::vector<std::int32_t> first_; ///< first column of each row
    std::vector<std::size_t> start_;  ///< [rows + 1] where a row starts in entries_; its diagonal is in d_
    std::vector<double> entries_;     ///< of L, below the diagonal of ones
    std::vector<double> d_;
};

} // namespace femoop
