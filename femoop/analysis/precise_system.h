#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "femoop/solver/precise_solver.h"

namespace femoop {

/// K x = F of a structure in 32 digits, for where doubles keep too few: long chains of members, tiny ones beside long
/// ones. Where the letters come from: femoop/analysis/reduced_system.h.
class PreciseSystem {
public:
    using Sparse = Eigen::SparseMatrix<double>;
    /// A stiffness, and its factorization in doubles: null where that broke down, or there is nothing to factor.
    struct Part {
        const PreciseSparseMatrix& K;
        const SymmetricSolver* rough = nullptr;
    };

    explicit PreciseSystem(const Part& elastic); ///< without constraints
    PreciseSystem(const Part& elastic, const Part& own, const Sparse& T, const Sparse& S);

    struct Displacements {
        PreciseMatrix all, constraint;
        Eigen::VectorXd out_of_balance; ///< largest force, of every load case
    };
    /// Nothing where the system is too ill-conditioned. `x0` is empty without constraints.
    std::optional<Displacements> solve(const PreciseMatrix& F, const Eigen::MatrixXd& x0);

private:
    PreciseSparseMatrix K_, own_, T_, S_;
    std::unique_ptr<PreciseSolver> solver_, own_solver_;
};

} // namespace femoop
