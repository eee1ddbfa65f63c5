#include "femoop/solver/multifrontal/front_solution.h"

#include <memory>
#include <vector>

#include "femoop/solver/index.h"
#include "femoop/solver/multifrontal/dense_front.h"
#include "femoop/solver/multifrontal/schedule.h"

namespace femoop {

namespace {

using Front = FrontTree::Front;

/// Of one right-hand side, which is quicker where the compiler knows that it is one, or of many.
template <int columns_at_compile_time> class Solution {
public:
    using Columns = Eigen::Matrix<double, Eigen::Dynamic, columns_at_compile_time>;

    Solution(const FrontTree& tree, const FrontFactor& factor, Eigen::Map<Columns> X)
        : tree_(tree),
          fronts_(tree.fronts()),
          factor_(factor),
          X_(X),
          carried_(std::make_unique_for_overwrite<double[]>(tree.n_rows() * static_cast<std::size_t>(X.cols())))
    {}

    void run(Team& team)
    {
        const Schedule schedule(tree_, team.size());
        const auto n_tasks = static_cast<std::int32_t>(schedule.tasks.size());
        team.for_each(n_tasks, [&](std::int32_t task, int) {
            for (std::int32_t f = schedule.tasks[at(task)].first; f < schedule.tasks[at(task)].end; ++f) go_up(f);
        });
        for (const std::int32_t f : schedule.top) go_up(f);
        for (std::size_t i = schedule.top.size(); i-- > 0;) go_down(schedule.top[i]);
        team.for_each(n_tasks, [&](std::int32_t task, int) {
            for (std::int32_t f = schedule.tasks[at(task)].end; f-- > schedule.tasks[at(task)].first;) go_down(f);
        });
    }

private:
    static constexpr bool is_one = columns_at_compile_time == 1;
    using Block = Eigen::Map<Columns>;

    /// A right-hand side for the rows of a front: of its pivots, and what it hands to its parent.
    Block block(const Front& front)
    {
        return {carried_.get() + front.first_row * static_cast<std::size_t>(X_.cols()), front.n_rows, X_.cols()};
    }
    Eigen::Map<const Eigen::MatrixXd> columns(const Front& front) const
    {
        return {factor_.entries.get() + front.first_entry, front.n_rows, front.n_pivots};
    }

    void go_up(std::int32_t f)
    {
        const Front& front = fronts_[at(f)];
        const std::span<const std::int32_t> rows = tree_.rows(front);
        Block b = block(front);
        for (Eigen::Index c = 0; c < b.cols(); ++c)
            for (std::int32_t i = 0; i < front.n_pivots; ++i) b(i, c) = X_(rows[at(i)], c);
        b.bottomRows(front.n_updated()).setZero();
        for (std::int32_t child = front.first_child; child != FrontTree::none; child = fronts_[at(child)].next_sibling)
            add(fronts_[at(child)], b);
        auto pivots = b.topRows(front.n_pivots);
        if (factor_.exchanges()) put_in_order(front, pivots);
        solve_forward(front, b);
        for (Eigen::Index c = 0; c < b.cols(); ++c) divide(front, pivots.col(c));
        put_pivots(front, pivots);
    }
    void add(const Front& child, Block& b)
    {
        const std::span<const std::int32_t> places = tree_.places_in_parent(child);
        const Block from = block(child);
        for (Eigen::Index c = 0; c < b.cols(); ++c)
            for (std::int32_t i = 0; i < child.n_updated(); ++i) b(places[at(i)], c) += from(child.n_pivots + i, c);
    }

    void go_down(std::int32_t f)
    {
        const Front& front = fronts_[at(f)];
        const std::span<const std::int32_t> rows = tree_.rows(front);
        Block x = block(front);
        for (Eigen::Index c = 0; c < x.cols(); ++c) {
            for (std::int32_t i = 0; i < front.n_pivots; ++i) x(i, c) = X_(factor_.equation(tree_, front, i), c);
            for (std::int32_t i = front.n_pivots; i < front.n_rows; ++i) x(i, c) = X_(rows[at(i)], c);
        }
        solve_backward(front, x);
        put_pivots(front, x.topRows(front.n_pivots));
    }

    void solve_forward(const Front& front, Block& b) const
    {
        const auto L = columns(front);
        if constexpr (is_one) {
            kernel_.solve_forward({L.data(), front.n_pivots, front.n_rows}, b.data());
            return;
        }
        auto pivots = b.topRows(front.n_pivots);
        L.topRows(front.n_pivots).template triangularView<Eigen::UnitLower>().solveInPlace(pivots);
        b.bottomRows(front.n_updated()).noalias() -= L.bottomRows(front.n_updated()) * pivots;
    }

    void solve_backward(const Front& front, Block& x) const
    {
        const auto L = columns(front);
        if constexpr (is_one) {
            kernel_.solve_backward({L.data(), front.n_pivots, front.n_rows}, x.data());
            return;
        }
        auto pivots = x.topRows(front.n_pivots);
        pivots.noalias() -= L.bottomRows(front.n_updated()).transpose() * x.bottomRows(front.n_updated());
        L.topRows(front.n_pivots).template triangularView<Eigen::UnitLower>().transpose().solveInPlace(pivots);
    }

    template <class Pivots> void put_in_order(const Front& front, Pivots& pivots) const
    {
        const Eigen::MatrixXd before = pivots;
        for (std::int32_t i = 0; i < front.n_pivots; ++i)
            pivots.row(i) = before.row(factor_.order[front.first_row + at(i)]);
    }

    template <class Pivots> void put_pivots(const Front& front, const Pivots& pivots)
    {
        for (Eigen::Index c = 0; c < X_.cols(); ++c)
            for (std::int32_t i = 0; i < front.n_pivots; ++i) X_(factor_.equation(tree_, front, i), c) = pivots(i, c);
    }

    /// By D.
    template <class Column> void divide(const Front& front, Column&& x) const
    {
        const auto L = columns(front);
        for (std::int32_t i = 0; i < front.n_pivots; ++i) {
            const double a = L(i, i), b = factor_.coupled(front, i);
            if (b == 0.0) {
                x[i] /= a;
                continue;
            }
            const double c = L(i + 1, i + 1), determinant = (a / b) * c - b; // over b
            const double first = (c / b * x[i] - x[i + 1]) / determinant;
            x[i + 1] = (a / b * x[i + 1] - x[i]) / determinant;
            x[i++] = first;
        }
    }

    const FrontTree& tree_;
    const std::vector<Front>& fronts_;
    const FrontFactor& factor_;
    const DenseKernel& kernel_ = dense_kernel();
    Eigen::Map<Columns> X_;
    std::unique_ptr<double[]> carried_; ///< the blocks of all fronts
};

template <int columns> void run(const FrontTree& tree, const FrontFactor& factor, Eigen::MatrixXd& B, Team& team)
{
    Solution<columns>(tree, factor, {B.data(), B.rows(), B.cols()}).run(team);
}

} // namespace

Eigen::MatrixXd solve_fronts(const FrontTree& tree, const FrontFactor& factor, Eigen::MatrixXd B, Team& team)
{
    if (B.cols() == 1) run<1>(tree, factor, B, team);
    else run<Eigen::Dynamic>(tree, factor, B, team);
    return B;
}

} // namespace femoop
