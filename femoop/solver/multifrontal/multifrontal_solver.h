#pragma once

#include "femoop/solver/multifrontal/front_factor.h"
#include "femoop/solver/multifrontal/front_tree.h"
#include "femoop/solver/symmetric_solver.h"

namespace femoop {

/// Ours: dense fronts up the elimination tree (multifrontal/front_tree.h), K = L D L'. Threads work on subtrees at a
/// time; results are the same bit for bit whatever their number. Where signs may be any, pivots are exchanged within
/// their front; one that is zero in all of its front ends the factorization.
///
/// Source  [DuffReid1983], exchanges [BunchKaufman1977]
class MultifrontalSolver final : public SymmetricSolver {
public:
    MultifrontalSolver(); ///< a thread for every processor
    explicit MultifrontalSolver(int n_threads);

    std::size_t factor_nonzeros() const override { return tree_.n_entries(); }
    double predicted_operations() const override { return tree_.n_operations(); }
    double predicted_bytes() const override { return predicted_bytes_; }
    std::string_view name() const override { return "multifrontal"; }

private:
    void analyse_ordered(Pattern pattern) override;
    Pivots factorize_ordered(const SparseMatrix& K, Signs signs) override;
    Eigen::MatrixXd solve_ordered(Eigen::MatrixXd B) const override;
    int team_for(double n_operations) const;

    int n_threads_;
    FrontTree tree_;
    double predicted_bytes_ = 0.0;
    FrontFactor factor_;
};

} // namespace femoop
