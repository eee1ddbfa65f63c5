#include "femoop/analysis/unstressed_cases.h"

#include <algorithm>
#include <cmath>

#include "femoop/analysis/settlement_force.h"
#include "femoop/result/end_vectors.h"

namespace femoop {

namespace {

constexpr double rounding = 1e-12; // of what would hold the structure in place

bool has_forces(const CaseLoads& loads)
{
    const auto is_force = [](const SpanLoad& load) {
        return load.kind != SpanLoad::Kind::Strain && (load.start != 0.0 || load.end != 0.0);
    };
    const auto is_zero = [](double value) { return value == 0.0; };
    return !loads.elements.empty() || std::ranges::any_of(loads.span_loads, is_force) ||
           std::ranges::any_of(loads.nodes,
                               [&](const auto& load) { return !std::ranges::all_of(load.value, is_zero); });
}

/// What would hold the structure as it was, at least.
double holding_force(const Discretisation& structure, const CaseLoads& loads)
{
    double largest = settlement_force(structure, loads);
    for (std::size_t i = 0; i < structure.members.size(); ++i)
        for (const SpanLoad& load : loads.of(MemberId(i))) {
            if (load.kind != SpanLoad::Kind::Strain) continue;
            const MemberProperties& properties = structure.properties_of(MemberId(i));
            largest = std::max({largest, std::abs(properties.axial.EA * load.start),
                                std::abs(properties.xy.EI * load.end) / structure.size()});
        }
    return std::isfinite(largest) ? largest : 0.0;
}

/// Of reactions and at the members' ends, a moment by the structure's size; what is no number is above.
bool is_force_above(double limit, const detail::Solution& solution, std::size_t load_case)
{
    const Discretisation& structure = *solution.structure;
    const double moment_limit = limit * structure.size();
    const auto is_above = [&](const auto& v) {
        for (std::size_t i = 0; i < n_dofs; ++i)
            if (!(std::abs(v.data()[i]) <= (i < 3 ? limit : moment_limit))) return true;
        return false;
    };
    if (std::ranges::any_of(solution.solutions[load_case].reactions, is_above)) return true;
    for (std::size_t i = 0; i < structure.members.size(); ++i)
        if (std::ranges::any_of(end_forces(solution, load_case, MemberId(i)), is_above)) return true;
    return false;
}

} // namespace

void mark_unstressed_cases(detail::Solution& solution)
{
    for (std::size_t c = 0; c < solution.solutions.size(); ++c) {
        const CaseLoads& loads = solution.loads[c];
        if (has_forces(loads)) continue;
        const double limit = rounding * holding_force(*solution.structure, loads);
        if (limit == 0.0 || is_force_above(limit, solution, c)) continue;
        detail::CaseSolution& unstressed = solution.solutions[c];
        unstressed.is_unstressed = true;
        std::ranges::fill(unstressed.reactions, NodeVector{});
        unstressed.equilibrium.sum_reactions = {};
    }
}

} // namespace femoop
