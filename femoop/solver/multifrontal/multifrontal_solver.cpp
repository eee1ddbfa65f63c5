#include "femoop/solver/multifrontal/multifrontal_solver.h"

#include <utility>

#include "femoop/solver/available_memory.h"
#include "femoop/solver/multifrontal/front_factorization.h"
#include "femoop/solver/multifrontal/front_memory.h"
#include "femoop/solver/multifrontal/front_solution.h"
#include "femoop/solver/team.h"

namespace femoop {

namespace {

constexpr double worth_threads = 1e7; // multiplications, of which a team takes some to assemble

} // namespace

MultifrontalSolver::MultifrontalSolver() : n_threads_(Team::natural_size()) {}

MultifrontalSolver::MultifrontalSolver(int n_threads) : n_threads_(n_threads) {}

int MultifrontalSolver::team_for(double n_operations) const { return n_operations < worth_threads ? 1 : n_threads_; }

void MultifrontalSolver::analyse_ordered(Pattern pattern)
{
    factor_ = {};
    tree_ = FrontTree({.column_start = pattern.column_start, .rows = pattern.rows});
    const int n_members = team_for(tree_.n_operations());
    predicted_bytes_ = FrontMemory(tree_, Schedule(tree_, n_members), Depths(tree_.fronts())).bytes(tree_, n_members);
    if (const double limit = memory_limit(); predicted_bytes_ > limit)
        throw InsufficientMemory(predicted_bytes_, limit);
    factor_.entries = make_numbers(tree_.n_entries());
}

Pivots MultifrontalSolver::factorize_ordered(const SparseMatrix& K, Signs signs)
{
    const std::size_t exchanged = signs == Signs::Any ? tree_.n_rows() : 0;
    factor_.order.resize(exchanged);
    factor_.coupling.resize(exchanged);
    Team team(team_for(tree_.n_operations()));
    return factorize_fronts(tree_, {.K = K, .reference = references(K, signs), .signs = signs}, factor_, team,
                            progress());
}

Eigen::MatrixXd MultifrontalSolver::solve_ordered(Eigen::MatrixXd B) const
{
    Team team(team_for(2.0 * static_cast<double>(tree_.n_entries()) * static_cast<double>(B.cols())));
    return solve_fronts(tree_, factor_, std::move(B), team);
}

} // namespace femoop
