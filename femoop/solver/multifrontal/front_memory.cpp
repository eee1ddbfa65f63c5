#include "femoop/solver/multifrontal/front_memory.h"

#include <algorithm>
#include <cstdint>

#include "femoop/solver/index.h"
#include "femoop/solver/multifrontal/dense_front.h"

namespace femoop {

namespace {

template <class Visit> void for_each_child(const std::vector<FrontTree::Front>& fronts, std::int32_t f, Visit visit)
{
    for (std::int32_t c = fronts[at(f)].first_child; c != FrontTree::none; c = fronts[at(c)].next_sibling)
        visit(fronts[at(c)]);
}

} // namespace

Depths::Depths(const std::vector<FrontTree::Front>& fronts) : is_odd_(fronts.size(), false)
{
    for (std::size_t f = fronts.size(); f-- > 0;)
        if (fronts[f].parent != FrontTree::none) is_odd_[f] = !is_odd_[at(fronts[f].parent)];
}

FrontMemory::FrontMemory(const FrontTree& tree, const Schedule& schedule, const Depths& depths)
{
    const std::vector<FrontTree::Front>& fronts = tree.fronts();
    for (const FrontTree::Front& front : fronts)
        workspace = std::max(workspace, workspace_size(front.n_pivots, front.n_rows));
    std::size_t given = 0; // by tasks to those above
    for (const Schedule::Task& task : schedule.tasks) {
        std::array<std::size_t, 2> held{0, 0};
        for (std::int32_t f = task.first; f < task.end; ++f) {
            const std::size_t side = depths.side(f);
            (waits_in_task(fronts[at(f)], task) ? held[side] : given) += update_size(fronts[at(f)]);
            stacks[side] = std::max(stacks[side], held[side]);
            for_each_child(fronts, f, [&](const FrontTree::Front& c) { held[1 - side] -= update_size(c); });
        }
    }
    handed_up = given;
    for (const std::int32_t f : schedule.top) {
        given += update_size(fronts[at(f)]);
        handed_up = std::max(handed_up, given);
        for_each_child(fronts, f, [&](const FrontTree::Front& c) { given -= update_size(c); });
    }
}

double FrontMemory::bytes(const FrontTree& tree, int n_members) const
{
    const auto in_doubles = [](std::size_t n) { return static_cast<double>(n) * sizeof(double); };
    const double of_member = in_doubles(stacks[0] + stacks[1] + workspace) +
                             static_cast<double>(tree.n_equations() * sizeof(std::int32_t));
    return in_doubles(tree.n_entries() + handed_up + tree.n_rows()) + n_members * of_member;
}

} // namespace femoop
