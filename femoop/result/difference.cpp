#include "femoop/result/difference.h"

#include <cmath>
#include <string>

#include "femoop/result/components.h"

namespace femoop {

namespace {

/// The one of that name, which most often stands at the same place.
template <class Id, class List, class Find>
std::optional<Id> namesake(const List& former, Id place, const std::string& name, const Find& find)
{
    if (place.index < former.size() && former[place.index].id == name) return place;
    return find(name);
}

std::optional<MemberId> former_member(const Model& then, const Model& now, MemberId member)
{
    return namesake(then.members, member, now[member].id,
                    [&](const std::string& name) { return then.find_member(name); });
}

std::optional<NodeId> former_node(const Model& then, const Model& now, NodeId node)
{
    return namesake(then.nodes, node, now[node].id, [&](const std::string& name) { return then.find_node(name); });
}

} // namespace

Differences::Differences(const ComparedCase& now, const ComparedCase& then)
    : now_(now), then_(then), now_sizes_(now.result.magnitudes()), then_sizes_(then.result.magnitudes())
{
    if (now.model->analysis != then.model->analysis) return;
    for (const MemberComponent component : section_force_components(now.model->analysis))
        components_.push_back(component);
    dofs_ = dof_list(now.model->analysis);
    for (std::size_t i = 0; i < now.model->nodes.size(); ++i)
        if (now.result.is_supported(NodeId(i))) supported_.emplace_back(i);
}

std::size_t Differences::size() const
{
    return now_.model->members.size() * components_.size() +
           (supported_.size() + now_.model->nodes.size()) * dofs_.size();
}

Difference Differences::operator[](std::size_t place) const
{
    const std::size_t n_forces = now_.model->members.size() * components_.size();
    if (place < n_forces) return force(MemberId(place / components_.size()), components_[place % components_.size()]);
    place -= n_forces;
    const Dof dof = dofs_[place % dofs_.size()];
    const std::size_t node = place / dofs_.size();
    if (node < supported_.size()) return reaction(supported_[node], dof);
    return displacement(NodeId(node - supported_.size()), dof);
}

Difference Differences::force(MemberId member, MemberComponent component) const
{
    const auto of = [&](const ComparedCase& which, const Magnitudes& sizes, MemberId id) {
        return without_rounding(largest(which.result.curve(id), component), sizes.of(component));
    };
    Difference one{ComparedQuantity::SectionForce, member, component, of(now_, now_sizes_, member)};
    if (const auto former = former_member(*then_.model, *now_.model, member))
        one.then = of(then_, then_sizes_, *former);
    return one;
}

Difference Differences::reaction(NodeId node, Dof dof) const
{
    const auto of = [&](const ComparedCase& which, const Magnitudes& sizes, NodeId id) {
        return without_rounding(which.result.reaction(id)[index(dof)], sizes.force_of(dof));
    };
    Difference one{ComparedQuantity::Reaction, node, dof, of(now_, now_sizes_, node)};
    const auto former = former_node(*then_.model, *now_.model, node);
    if (former && then_.result.is_supported(*former)) one.then = of(then_, then_sizes_, *former);
    return one;
}

Difference Differences::displacement(NodeId node, Dof dof) const
{
    const auto of = [&](const ComparedCase& which, const Magnitudes& sizes, NodeId id) {
        return without_rounding(which.result.displacement(id)[index(dof)], sizes.displacement_of(dof));
    };
    Difference one{ComparedQuantity::Displacement, node, dof, of(now_, now_sizes_, node)};
    if (const auto former = former_node(*then_.model, *now_.model, node)) one.then = of(then_, then_sizes_, *former);
    return one;
}

double largest(const Curve& curve, MemberComponent component)
{
    const Extremes extremes = curve.extremes(component);
    return std::abs(extremes.min.value) > std::abs(extremes.max.value) ? extremes.min.value : extremes.max.value;
}

} // namespace femoop
