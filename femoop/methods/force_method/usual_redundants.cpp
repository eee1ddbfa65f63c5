#include "femoop/methods/force_method/usual_redundants.h"

#include <algorithm>
#include <string>
#include <utility>

#include "femoop/analysis/linear_static.h"
#include "femoop/edit/naming.h"
#include "femoop/result/components.h"

namespace femoop::force_method {

namespace {

Redundant section_force(MemberId member, MemberComponent component, double percent)
{
    return {
        .quantity = ExpectedQuantity::SectionForce, .member = member, .component = component, .at = Percent{percent}};
}

/// The order in which supports are released, and what they hold.
struct Held {
    NodeId node;
    std::ptrdiff_t n_members;
    std::vector<Dof> dofs;
};

std::vector<Held> supports(const Model& model)
{
    std::vector<Held> all;
    for (std::size_t i = model.nodes.size(); i-- > 0;) {
        const auto& support = model.nodes[i].support;
        if (!support) continue;
        const auto meets = [&](const Member& one) {
            return std::ranges::find(one.nodes, NodeId(i)) != one.nodes.end();
        };
        Held held{NodeId(i), std::ranges::count_if(model.members, meets), {}};
        for (const Dof dof : dof_list(model.analysis))
            if (holds(*support, dof, model.analysis)) held.dofs.push_back(dof);
        all.push_back(std::move(held));
    }
    std::ranges::stable_sort(all, [](const Held& a, const Held& b) {
        return a.n_members != b.n_members ? a.n_members > b.n_members : a.dofs.size() < b.dofs.size();
    });
    return all;
}

std::vector<Redundant> candidates(const Model& model)
{
    std::vector<Redundant> all;
    for (const Held& support : supports(model))
        for (const Dof dof : support.dofs)
            all.push_back({.quantity = ExpectedQuantity::Reaction, .node = support.node, .dof = dof});
    const auto add_members = [&](bool of_moments) {
        for (std::size_t i = model.members.size(); i-- > 0;)
            for (const MemberComponent force : section_force_components(model.analysis)) {
                if (is_moment(force) != of_moments) continue;
                all.push_back(section_force(MemberId(i), force, 0.0));
                if (of_moments) all.push_back(section_force(MemberId(i), force, 100.0));
            }
    };
    add_members(true);
    for (std::size_t i = model.members.size(); i-- > 0;)
        if (model.members[i].foundation) all.push_back(section_force(MemberId(i), MemberComponent::Mz, 50.0));
    add_members(false);
    std::erase_if(all, [&](const Redundant& one) { return !check_redundants(model, {&one, 1}, {}).empty(); });
    return all;
}

/// The ground makes a structure indeterminate that would not stand without it: then one force is chosen that it can do
/// without.
std::size_t n_wanted(const Indeterminacy& degree)
{
    return static_cast<std::size_t>(std::max(degree.total(), degree.has_foundation ? 1 : 0));
}

} // namespace

bool is_stable(const Model& model, std::span<const Redundant> redundants)
{
    PrimaryStructure primary = primary_structure(model, redundants);
    primary.model.load_cases.clear();
    for (const Release& release : primary.releases)
        primary.model.load_cases.push_back(
            unit_state(primary.model, release, std::to_string(primary.model.load_cases.size())));
    try {
        analyse(primary.model);
        return true;
    } catch (const MechanismError&) {
        return false;
    }
}

std::vector<Redundant> usual_redundants(const Model& model, const Indeterminacy& degree)
{
    if (degree.total() > most_redundants)
        throw ModelError(
            {Fault{FaultKind::RedundantsTooMany, {std::to_string(degree.total()), std::to_string(most_redundants)}}});
    std::vector<Redundant> chosen;
    for (const Redundant& one : candidates(model)) {
        if (chosen.size() == n_wanted(degree)) break;
        chosen.push_back(one);
        if (!is_stable(model, chosen)) chosen.pop_back();
    }
    return chosen;
}

} // namespace femoop::force_method
