#include "femoop/solver/elimination_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "femoop/solver/index.h"

namespace femoop {

namespace {

// Measured: courseware/decisions/0009-the-profile-decides.md
constexpr std::size_t largest_profile = 50000; // unknowns: of more the profile is not looked at
constexpr double most_work = 2e7;              // within the profile
constexpr double wide = 150.0;                 // mean height of the profile: dissection beats minimum degree

} // namespace

double profile_work(const BlockGraph& graph, const BlockAdjacency& adjacency, const std::vector<std::int32_t>& order)
{
    std::vector<std::int32_t> first_equation(order.size());
    std::int32_t equation = 0;
    for (const std::int32_t block : order) {
        first_equation[at(block)] = equation;
        equation += graph.block_sizes[at(block)];
    }
    double work = 0.0;
    for (const std::int32_t block : order) {
        std::int32_t first = first_equation[at(block)];
        for (const std::int32_t other : adjacency.of(block)) first = std::min(first, first_equation[at(other)]);
        const double height = first_equation[at(block)] - first;
        work += graph.block_sizes[at(block)] * height * height;
    }
    return work;
}

EliminationPlan plan_elimination(SolverKind wanted, const BlockGraph& graph, const BlockAdjacency& adjacency)
{
    const std::size_t n = graph.n_unknowns();
    const SolverKind sparse = wanted == SolverKind::Automatic ? SolverKind::Multifrontal : wanted;
    bool is_wide = true;
    if (wanted == SolverKind::Skyline || n <= largest_profile) {
        std::vector<std::int32_t> narrow = elimination_order(adjacency, Ordering::CuthillMcKee);
        const double work = profile_work(graph, adjacency, narrow);
        if (wanted == SolverKind::Skyline || (wanted == SolverKind::Automatic && work <= most_work))
            return {.solver = SolverKind::Skyline, .order = std::move(narrow), .ordering = Ordering::CuthillMcKee};
        is_wide = work > wide * wide * static_cast<double>(n);
    }
    const Ordering ordering = is_wide ? Ordering::NestedDissection : Ordering::MinimumDegree;
    return {.solver = sparse, .order = elimination_order(adjacency, ordering, graph.positions), .ordering = ordering};
}

} // namespace femoop
