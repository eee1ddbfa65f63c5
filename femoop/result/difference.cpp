#include "femoop/result/difference.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

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

/// The ends, and where either is largest or smallest.
std::vector<double> compared_shares(const Curve& now, const std::optional<Curve>& then, MemberComponent component)
{
    std::vector<double> shares{0.0, 1.0};
    const auto add = [&](const Curve& curve) {
        const auto [max, min] = curve.extremes(component);
        for (const double x : {max.x, min.x}) shares.push_back(std::clamp(x / curve.length(), 0.0, 1.0));
    };
    add(now);
    if (then) add(*then);
    return shares;
}

constexpr double same_length = 1e-9; // of it

/// Of two sections the one where more has changed, else where there is more now.
bool is_larger(const Difference& a, const Difference& b)
{
    const double change = std::abs(a.change().value_or(0.0)), other = std::abs(b.change().value_or(0.0));
    return change != other ? change > other : std::abs(a.now) > std::abs(b.now);
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
    const Curve curve = now_.result.curve(member);
    const auto former = former_member(*then_.model, *now_.model, member);
    const std::optional<Curve> past = former ? std::optional(then_.result.curve(*former)) : std::nullopt;
    const double now_size = now_sizes_.of(component), then_size = then_sizes_.of(component);
    const auto at = [&](double share, Side side) {
        Difference one{.quantity = ComparedQuantity::SectionForce, .part = member, .component = component};
        one.now = without_rounding(curve.value(component, share * curve.length(), side), now_size);
        if (past) one.then = without_rounding(past->value(component, share * past->length(), side), then_size);
        one.share = share;
        one.is_as_long = !past || std::abs(past->length() - curve.length()) <= same_length * curve.length();
        one.size = std::max(now_size, then_size);
        return one;
    };
    std::optional<Difference> most;
    for (const double share : compared_shares(curve, past, component))
        for (const Side side : {Side::Before, Side::After}) {
            if (share == (side == Side::Before ? 0.0 : 1.0)) continue;
            const Difference one = at(share, side);
            if (!most || is_larger(one, *most)) most = one;
        }
    return most.value();
}

Difference Differences::reaction(NodeId node, Dof dof) const
{
    const auto of = [&](const ComparedCase& which, const Magnitudes& sizes, NodeId id) {
        return without_rounding(which.result.reaction(id)[index(dof)], sizes.force_of(dof));
    };
    Difference one{.quantity = ComparedQuantity::Reaction, .part = node, .component = dof};
    one.now = of(now_, now_sizes_, node);
    one.size = std::max(now_sizes_.force_of(dof), then_sizes_.force_of(dof));
    const auto former = former_node(*then_.model, *now_.model, node);
    if (former && then_.result.is_supported(*former)) one.then = of(then_, then_sizes_, *former);
    return one;
}

Difference Differences::displacement(NodeId node, Dof dof) const
{
    const auto of = [&](const ComparedCase& which, const Magnitudes& sizes, NodeId id) {
        return without_rounding(which.result.displacement(id)[index(dof)], sizes.displacement_of(dof));
    };
    Difference one{.quantity = ComparedQuantity::Displacement, .part = node, .component = dof};
    one.now = of(now_, now_sizes_, node);
    one.size = std::max(now_sizes_.displacement_of(dof), then_sizes_.displacement_of(dof));
    if (const auto former = former_node(*then_.model, *now_.model, node)) one.then = of(then_, then_sizes_, *former);
    return one;
}

} // namespace femoop
