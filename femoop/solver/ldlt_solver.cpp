#include "femoop/solver/ldlt_solver.h"

namespace femoop {

std::size_t LdltSolver::factor_nonzeros() const
{
    const auto& L = ldlt_.matrixL().nestedExpression(); // its diagonal of ones is not kept, but D is
    return static_cast<std::size_t>(L.nonZeros() + L.cols());
}

void LdltSolver::analyse_ordered(Pattern pattern)
{
    const auto n = static_cast<Eigen::Index>(pattern.n());
    const std::vector<double> zeros(pattern.rows.size(), 0.0);
    ldlt_.analyzePattern(Eigen::Map<const SparseMatrix>(
        n, n, static_cast<Eigen::Index>(zeros.size()), pattern.column_start.data(), pattern.rows.data(), zeros.data()));
}

Pivots LdltSolver::factorize_ordered(const SparseMatrix& K, Signs signs)
{
    ldlt_.factorize(K);
    const Eigen::VectorXd reference = references(K, signs);
    Pivots pivots;
    for (std::int32_t i = 0; i < K.cols(); ++i)
        if (!pivots.note(i, ldlt_.vectorD()[i], reference[i], signs)) break;
    return pivots;
}

Eigen::MatrixXd LdltSolver::solve_ordered(Eigen::MatrixXd B) const { return ldlt_.solve(B); }

} // namespace femoop
