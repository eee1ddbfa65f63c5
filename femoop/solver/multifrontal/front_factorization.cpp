#include "femoop/solver/multifrontal/front_factorization.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "femoop/solver/index.h"
#include "femoop/solver/multifrontal/checkpoint.h"
#include "femoop/solver/multifrontal/dense_front.h"
#include "femoop/solver/multifrontal/front_memory.h"
#include "femoop/solver/multifrontal/numbers.h"
#include "femoop/solver/multifrontal/schedule.h"

namespace femoop {

namespace {

using Front = FrontTree::Front;
using Workspace = std::unique_ptr<double[]>;

constexpr std::int32_t columns_at_once = 128; // of a large front that a member of the team assembles

/// Memory that is taken and given back in the order of a stack.
class Stack {
public:
    explicit Stack(std::size_t size) : numbers_(std::make_unique_for_overwrite<double[]>(size)) {}
    double* push(std::size_t n) { return numbers_.get() + std::exchange(top_, top_ + n); }
    double* pop(std::size_t n) { return numbers_.get() + (top_ -= n); }

private:
    Workspace numbers_;
    std::size_t top_ = 0;
};

/// What a member of the team works with.
struct Bench {
    std::array<Stack, 2> stacks;
    Workspace workspace;
    std::vector<std::int32_t> place; ///< of an equation in the present front
};

class Factorization {
public:
    Factorization(const FrontTree& tree, const SystemNumbers& system, FrontFactor& factor, Team& team,
                  const Progress& progress)
        : tree_(tree),
          fronts_(tree.fronts()),
          K_(system.K),
          signs_(system.signs),
          reference_(system.reference),
          factor_(factor),
          team_(team),
          checkpoint_(progress, tree.n_operations()),
          schedule_(tree, team.size()),
          depths_(fronts_),
          handed_up_(fronts_.size())
    {}

    Pivots run()
    {
        std::vector<Bench> benches = make_benches();
        std::vector<Pivots> pivots(schedule_.tasks.size());
        team_.for_each(static_cast<std::int32_t>(pivots.size()), [&](std::int32_t task, int member) {
            pivots[at(task)] = eliminate_task(schedule_.tasks[at(task)], benches[at(member)], member);
        });
        Pivots all;
        for (const Pivots& of_task : pivots) all.include(of_task);
        for (std::size_t i = 0; i < schedule_.top.size() && all.is_complete; ++i)
            eliminate_top(schedule_.top[i], benches.front(), all);
        return all;
    }

private:
    /// One for each member of the team, with room for every task.
    std::vector<Bench> make_benches() const
    {
        const FrontMemory memory(tree_, schedule_, depths_);
        std::vector<Bench> benches;
        for (int member = 0; member < team_.size(); ++member)
            benches.push_back({.stacks = {Stack(memory.stacks[0]), Stack(memory.stacks[1])},
                               .workspace = std::make_unique_for_overwrite<double[]>(memory.workspace),
                               .place = std::vector<std::int32_t>(tree_.n_equations())});
        return benches;
    }

    /// Where the fronts of a task lie in L, one after the other.
    std::span<double> panels_of(const Schedule::Task& task) const
    {
        const Front &first = fronts_[at(task.first)], &last = fronts_[at(task.end - 1)];
        const std::size_t end = last.first_entry + at(last.n_rows) * at(last.n_pivots);
        return {factor_.entries.get() + first.first_entry, end - first.first_entry};
    }

    DenseFront dense(const Front& front, double* update) const
    {
        return {.panel = factor_.entries.get() + front.first_entry,
                .update = update,
                .n_pivots = front.n_pivots,
                .n_rows = front.n_rows,
                .order = factor_.exchanges() ? factor_.order.data() + front.first_row : nullptr,
                .coupling = factor_.exchanges() ? factor_.coupling.data() + front.first_row : nullptr};
    }

    double* hand_up(std::int32_t f)
    {
        handed_up_[at(f)] = std::make_unique_for_overwrite<double[]>(update_size(fronts_[at(f)]));
        return handed_up_[at(f)].get();
    }

    Pivots eliminate_task(const Schedule::Task& task, Bench& bench, int member)
    {
        Pivots pivots;
        PagesAhead pages(panels_of(task));
        for (std::int32_t f = task.first; f < task.end && pivots.is_complete; ++f) {
            const Front& front = fronts_[at(f)];
            checkpoint_.pass(member, elimination_work(front.n_pivots, front.n_rows));
            const std::size_t side = depths_.side(f);
            pages.provide(factor_.entries.get() + front.first_entry + at(front.n_rows) * at(front.n_pivots));
            const DenseFront here = dense(
                front, waits_in_task(front, task) ? bench.stacks[side].push(update_size(front)) : hand_up(f));
            find_places(front, bench);
            add_columns(here, front, 0, front.n_rows, bench.place);
            for (std::int32_t c = front.first_child; c != FrontTree::none; c = fronts_[at(c)].next_sibling)
                add_child(here, c, bench.stacks[1 - side].pop(update_size(fronts_[at(c)])), 0, front.n_rows);
            note(here, front, kernel_.eliminate(here, bench.workspace.get(), one_by_one), pivots);
        }
        return pivots;
    }

    /// A large front: all work on it together.
    void eliminate_top(std::int32_t f, Bench& bench, Pivots& pivots)
    {
        const Front& front = fronts_[at(f)];
        checkpoint_.pass(0, elimination_work(front.n_pivots, front.n_rows));
        const DenseFront here = dense(front, hand_up(f));
        find_places(front, bench);
        team_.for_each((front.n_rows + columns_at_once - 1) / columns_at_once, [&](std::int32_t part, int) {
            const std::int32_t begin = part * columns_at_once, end = std::min(front.n_rows, begin + columns_at_once);
            add_columns(here, front, begin, end, bench.place);
            for (std::int32_t c = front.first_child; c != FrontTree::none; c = fronts_[at(c)].next_sibling)
                add_child(here, c, handed_up_[at(c)].get(), begin, end);
        });
        for (std::int32_t c = front.first_child; c != FrontTree::none; c = fronts_[at(c)].next_sibling)
            handed_up_[at(c)].reset();
        const TileWorkers together{
            &team_, [](void* team, std::int32_t n, void (*work)(void*, std::int32_t), void* context) {
                static_cast<Team*>(team)->for_each(n, [&](std::int32_t tile, int) { work(context, tile); });
            }};
        note(here, front, kernel_.eliminate(here, bench.workspace.get(), together), pivots);
    }

    void find_places(const Front& front, Bench& bench) const
    {
        const std::span<const std::int32_t> rows = tree_.rows(front);
        for (std::size_t i = 0; i < rows.size(); ++i) bench.place[at(rows[i])] = static_cast<std::int32_t>(i);
    }

    /// Column j of a front's lower triangle, to be indexed with its rows.
    static double* column(const DenseFront& front, std::int32_t j)
    {
        const std::int32_t u = j - front.n_pivots;
        return u < 0 ? front.panel + at(j) * at(front.n_rows)
                     : front.update + at(u) * at(front.n_rows - front.n_pivots) - front.n_pivots;
    }

    /// Of K, in the columns begin .. end - 1 of the front, which were undefined.
    void add_columns(const DenseFront& here, const Front& front, std::int32_t begin, std::int32_t end,
                     const std::vector<std::int32_t>& place) const
    {
        const std::span<const std::int32_t> rows = tree_.rows(front);
        for (std::int32_t j = begin; j < end; ++j) {
            double* const entries = column(here, j);
            std::fill(entries + j, entries + front.n_rows, 0.0);
            if (j >= front.n_pivots) continue;
            const std::int32_t equation = rows[at(j)];
            for (std::int32_t k = K_.outerIndexPtr()[equation]; k < K_.outerIndexPtr()[equation + 1]; ++k)
                entries[place[at(K_.innerIndexPtr()[k])]] += K_.valuePtr()[k];
        }
    }

    /// A child's update matrix, where it falls into the columns begin .. end - 1 of its parent.
    void add_child(const DenseFront& here, std::int32_t c, const double* update, std::int32_t begin,
                   std::int32_t end) const
    {
        const std::span<const std::int32_t> places = tree_.places_in_parent(fronts_[at(c)]);
        const ChildUpdate child{update, places.data(), static_cast<std::int32_t>(places.size())};
        kernel_.add_update(here, child, begin, end);
    }

    void note(const DenseFront& here, const Front& front, std::int32_t done, Pivots& pivots) const
    {
        const auto note_one = [&](std::int32_t i, double pivot) {
            const std::int32_t equation = factor_.equation(tree_, front, i);
            return pivots.note(equation, pivot, reference_[equation], signs_);
        };
        for (std::int32_t i = 0; i < done; ++i) {
            const double d = column(here, i)[i], coupling = factor_.coupled(front, i);
            if (coupling == 0.0) {
                if (!note_one(i, d)) return;
                continue;
            }
            const std::array<double, 2> both = eigenvalues(d, coupling, column(here, i + 1)[i + 1]);
            note_one(i, both[0]);
            note_one(++i, both[1]);
        }
        if (done < front.n_pivots) note_one(done, 0.0);
    }

    /// Of [a b; b c], which is indefinite: the determinant gives the smaller one without cancellation.
    static std::array<double, 2> eigenvalues(double a, double b, double c)
    {
        const double mean = 0.5 * (a + c), spread = std::hypot(0.5 * (a - c), b);
        const double larger = mean < 0.0 ? mean - spread : mean + spread;
        return {larger, (a / larger) * c - (b / larger) * b};
    }

    const FrontTree& tree_;
    const std::vector<Front>& fronts_;
    const SparseMatrix& K_;
    const Signs signs_;
    const Eigen::VectorXd& reference_;
    FrontFactor& factor_;
    Team& team_;
    Checkpoint checkpoint_;
    const Schedule schedule_;
    const Depths depths_;
    const DenseKernel& kernel_ = dense_kernel();
    std::vector<Workspace> handed_up_; ///< update matrices that are in no stack
};

} // namespace

Pivots factorize_fronts(const FrontTree& tree, const SystemNumbers& system, FrontFactor& factor, Team& team,
                        const Progress& progress)
{
    return Factorization(tree, system, factor, team, progress).run();
}

} // namespace femoop
