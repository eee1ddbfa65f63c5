#include "femoop/edit/load_change.h"

#include <utility>

namespace femoop {

void change_places(MemberLoad& load, const std::function<void(Position&)>& change)
{
    if (auto* const point = std::get_if<PointLoad>(&load.load)) change(point->at);
    auto* const distributed = std::get_if<DistributedLoad>(&load.load);
    if (!distributed) return;
    if (distributed->from) change(*distributed->from);
    if (distributed->to) change(*distributed->to);
}

void change_values(MemberLoad& load, const std::function<void(Dof, Quantity&, LoadAxes)>& change)
{
    const auto change_all = [&](std::vector<Component>& components, LoadAxes axes) {
        for (Component& component : components) change(component.dof, component.value, axes);
    };
    if (auto* const distributed = std::get_if<DistributedLoad>(&load.load))
        for (DistributedLoad::Value& value : distributed->values) {
            change(value.dof, value.start, distributed->axes);
            if (value.end) change(value.dof, *value.end, distributed->axes);
        }
    if (auto* const point = std::get_if<PointLoad>(&load.load)) change_all(point->components, point->axes);
    if (auto* const ends = std::get_if<EndLoads>(&load.load)) {
        change_all(ends->start, ends->axes);
        change_all(ends->end, ends->axes);
    }
}

void swap_ends(MemberLoad& load)
{
    if (auto* const ends = std::get_if<EndLoads>(&load.load)) std::swap(ends->start, ends->end);
    auto* const distributed = std::get_if<DistributedLoad>(&load.load);
    if (!distributed) return;
    std::swap(distributed->from, distributed->to);
    for (DistributedLoad::Value& value : distributed->values)
        if (value.end) std::swap(value.start, *value.end);
}

void swap_faces(MemberLoad& load)
{
    if (auto* const temperature = std::get_if<TemperatureLoad>(&load.load))
        std::swap(temperature->top, temperature->bottom);
}

} // namespace femoop
