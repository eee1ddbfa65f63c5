#pragma once

#include <Eigen/SparseCholesky>

#include "femoop/solver/symmetric_solver.h"

namespace femoop {

/// Eigen's simplicial L D L', column by column: no library besides, good up to some ten thousand equations.
class LdltSolver final : public SymmetricSolver {
public:
    std::size_t factor_nonzeros() const override;
    std::string_view name() const override { return "ldlt"; }

private:
    void analyse_ordered(Pattern pattern) override;
    Pivots factorize_ordered(const SparseMatrix& K, Signs signs) override;
    Eigen::MatrixXd solve_ordered(Eigen::MatrixXd B) const override;

    Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<std::int32_t>> ldlt_;
};

} // namespace femoop
