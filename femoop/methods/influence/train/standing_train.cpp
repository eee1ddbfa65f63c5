#include "femoop/methods/influence/train/standing_train.h"

#include <algorithm>
#include <utility>

namespace femoop::influence {

namespace {

constexpr double off_path = 1e-12; // of its length: so far beyond an end is the end

std::vector<Component> components_of(const NodeVector& load, double factor)
{
    std::vector<Component> components;
    for (const Dof dof : all_dofs)
        if (load[index(dof)] != 0.0) components.push_back({.dof = dof, .value = factor * load[index(dof)]});
    return components;
}

void append(LoadCase& load_case, const PathLayout& path, const NodeVector& load, const StandingForce& force)
{
    const PathPlace place = path.place(force.s);
    load_case.members.push_back(
        {place.member, PointLoad{.at = Quantity(place.x), .components = components_of(load, force.force)}});
}

void append(LoadCase& load_case, const PathMember& on, const NodeVector& load, const Stretch& stretch, double uniform)
{
    const double from = std::max(stretch.from, on.begin), to = std::min(stretch.to, on.end());
    if (!(to > from)) return;
    DistributedLoad distributed;
    for (const Component& component : components_of(load, uniform))
        distributed.values.push_back({.dof = component.dof, .start = component.value, .end = {}});
    if (from > on.begin || to < on.end()) {
        distributed.from = Quantity(on.x_of(on.is_reversed ? to : from));
        distributed.to = Quantity(on.x_of(on.is_reversed ? from : to));
    }
    load_case.members.push_back({on.member, std::move(distributed)});
}

} // namespace

std::vector<StandingForce> standing_forces(const MovingTrain& train, const Placing& placing, double length)
{
    std::vector<StandingForce> forces;
    const double near = off_path * length;
    if (placing.position) {
        double s = *placing.position;
        for (std::size_t i = 0; i < train.axles.size(); ++i) {
            if (i > 0) s += placing.reversed ? placing.spacings[i - 1] : -placing.spacings[i - 1];
            if (s >= -near && s <= length + near) forces.push_back({std::clamp(s, 0.0, length), train.axles[i], i});
        }
    }
    for (std::size_t i = 0; i < placing.concentrated.size(); ++i)
        if (const auto s = placing.concentrated[i]) forces.push_back({*s, train.concentrated[i], std::nullopt});
    return forces;
}

LoadCase standing_train(std::string id, const PathLayout& path, const NodeVector& load, const MovingTrain& train,
                        const Placing& placing)
{
    LoadCase load_case{.id = std::move(id)};
    for (const StandingForce& force : standing_forces(train, placing, path.length()))
        append(load_case, path, load, force);
    for (const PathMember& on : path.members)
        for (const Stretch& stretch : placing.uniform) append(load_case, on, load, stretch, train.uniform);
    return load_case;
}

} // namespace femoop::influence
