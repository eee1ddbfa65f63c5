#include "femoop/solver/multifrontal/schedule.h"

#include <cstddef>

namespace femoop {

namespace {

constexpr double tasks_per_worker = 4.0;

/// Of every front the work in the subtree below it and in itself.
std::vector<double> subtree_work(const std::vector<FrontTree::Front>& fronts)
{
    std::vector<double> work(fronts.size());
    for (std::size_t f = 0; f < fronts.size(); ++f) {
        work[f] += elimination_work(fronts[f].n_pivots, fronts[f].n_rows);
        if (fronts[f].parent != FrontTree::none) work[at(fronts[f].parent)] += work[f];
    }
    return work;
}

} // namespace

Schedule::Schedule(const FrontTree& tree, int n_workers)
{
    const std::vector<FrontTree::Front>& fronts = tree.fronts();
    const auto n = static_cast<std::int32_t>(fronts.size());
    if (n_workers <= 1) {
        tasks.push_back({0, n});
        return;
    }
    const std::vector<double> work = subtree_work(fronts);
    const double largest = tree.n_operations() / (tasks_per_worker * n_workers);
    const auto is_top = [&](std::int32_t f) { return work[at(f)] > largest; };
    bool begins_task = true;
    double gathered = 0.0;
    for (std::int32_t f = 0; f < n; ++f) {
        if (is_top(f)) {
            top.push_back(f);
            begins_task = true;
            continue;
        }
        if (begins_task) {
            tasks.push_back({f, f});
            gathered = 0.0;
        }
        tasks.back().end = f + 1;
        const std::int32_t parent = fronts[at(f)].parent;
        const bool is_whole = parent == FrontTree::none || is_top(parent);
        if (is_whole) gathered += work[at(f)];
        begins_task = is_whole && gathered > 0.5 * largest;
    }
}

} // namespace femoop
