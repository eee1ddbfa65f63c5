#include "apps/drawing/results/solved_case.h"

#include "femoop/result/curve_reader.h"

#include <algorithm>
#include <cmath>

namespace drawing {

using femoop::MemberComponent;

namespace {

double largest_of(const std::vector<femoop::Curve>& curves, MemberComponent component)
{
    double largest = 0.0;
    for (const femoop::Curve& curve : curves) {
        const femoop::Extremes e = curve.extremes(component);
        for (const double value : {e.max.value, e.min.value})
            if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    }
    return largest;
}

} // namespace

double SolvedCase::largest(MemberComponent component) const
{
    std::optional<double>& known = largest_[static_cast<std::size_t>(component)];
    if (!known) known = largest_of(curves, component);
    return *known;
}

std::optional<SolvedCase> solved_case(const femoop::Results& results, femoop::CaseId id)
{
    if (id.index >= results.n_cases()) return std::nullopt;
    SolvedCase solved(results[id]);
    solved.curves.reserve(results.n_members());
    femoop::CurveReader reader(solved.result);
    for (std::size_t i = 0; i < results.n_members(); ++i) solved.curves.push_back(reader.read(femoop::MemberId{i}));
    for (std::size_t i = 0; i < results.n_nodes(); ++i)
        if (solved.result.is_supported(femoop::NodeId{i}))
            solved.reactions.push_back(solved.result.reaction(femoop::NodeId{i}));
    return solved;
}

std::vector<MemberComponent> components(Show item, femoop::AnalysisKind kind)
{
    std::vector<MemberComponent> wanted;
    switch (item) {
    case Show::N: wanted = {MemberComponent::N}; break;
    case Show::V: wanted = {MemberComponent::Vy, MemberComponent::Vz}; break;
    case Show::M: wanted = {MemberComponent::My, MemberComponent::Mz}; break;
    case Show::T: wanted = {MemberComponent::T}; break;
    case Show::Vy: wanted = {MemberComponent::Vy}; break;
    case Show::Vz: wanted = {MemberComponent::Vz}; break;
    case Show::My: wanted = {MemberComponent::My}; break;
    case Show::Mz: wanted = {MemberComponent::Mz}; break;
    default: break;
    }
    std::erase_if(wanted, [&](MemberComponent c) { return femoop::name(c, kind).empty(); });
    return wanted;
}

std::vector<MemberComponent> shown_components(const ShowSet& show, femoop::AnalysisKind kind)
{
    std::vector<MemberComponent> shown;
    for (const Show item : {Show::N, Show::V, Show::Vy, Show::Vz, Show::M, Show::T, Show::My, Show::Mz}) {
        if (!show.contains(item)) continue;
        for (const MemberComponent component : components(item, kind))
            if (std::ranges::find(shown, component) == shown.end()) shown.push_back(component);
    }
    return shown;
}

double largest_value(const SolvedCase& solved, MemberComponent component, double size)
{
    constexpr double rounding = 1e-10;
    const double own = solved.largest(component);
    double force = 0.0;
    for (const MemberComponent c : {MemberComponent::N, MemberComponent::Vy, MemberComponent::Vz})
        force = std::max(force, solved.largest(c));
    for (const MemberComponent c : {MemberComponent::T, MemberComponent::My, MemberComponent::Mz})
        force = std::max(force, solved.largest(c) / size);
    for (const femoop::NodeVector& reaction : solved.reactions)
        for (const femoop::Dof dof : femoop::all_dofs)
            force = std::max(force, std::abs(reaction[femoop::index(dof)]) / (is_rotation(dof) ? size : 1.0));
    const bool is_force = component <= MemberComponent::Vz;
    return own > rounding * force * (is_force ? 1.0 : size) ? own : 0.0;
}

double round_below(double value)
{
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    const double lead = value / power;
    // A hair below 1, 2 or 5 counts as it.
    if (lead >= 5.0 * (1.0 - 1e-9)) return 5.0 * power;
    return (lead >= 2.0 * (1.0 - 1e-9) ? 2.0 : 1.0) * power;
}

} // namespace drawing
