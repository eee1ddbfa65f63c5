#include "femoop/load/load_components.h"

#include <utility>
#include <variant>

#include "femoop/load/place_along.h"

namespace femoop {

namespace {

class ComponentReader {
public:
    explicit ComponentReader(double L) : L_(L) {}

    std::vector<LoadComponent> components() { return std::move(components_); }

    void operator()(const DistributedLoad& load)
    {
        const double from = load.from ? along(*load.from, L_) : 0.0, to = load.to ? along(*load.to, L_) : L_;
        for (const DistributedLoad::Value& value : load.values)
            components_.push_back({.kind = LoadComponent::Kind::Line,
                                   .dof = value.dof,
                                   .axes = load.axes,
                                   .from = from,
                                   .to = to,
                                   .start = value.start,
                                   .end = value.end ? *value.end : value.start,
                                   .is_projected = load.projected});
    }
    void operator()(const PointLoad& load)
    {
        add(LoadComponent::Kind::Point, load.components, load.axes, along(load.at, L_));
    }
    void operator()(const EndLoads& load)
    {
        add(LoadComponent::Kind::End, load.start, load.axes, 0.0);
        add(LoadComponent::Kind::End, load.end, load.axes, L_);
    }
    void operator()(const TemperatureLoad& /*load*/) {}
    void operator()(const Misfit& /*load*/) {}

private:
    void add(LoadComponent::Kind kind, const std::vector<Component>& components, LoadAxes axes, double at)
    {
        for (const Component& component : components)
            components_.push_back(
                {.kind = kind, .dof = component.dof, .axes = axes, .from = at, .to = at, .start = component.value});
    }

    double L_;
    std::vector<LoadComponent> components_;
};

} // namespace

std::vector<LoadComponent> components_of(const MemberLoad& load, double L)
{
    ComponentReader reader(L);
    std::visit(reader, load.load);
    return reader.components();
}

Eigen::Vector3d direction_of(const LoadComponent& component, const MemberGeometry& geometry)
{
    const auto axis = static_cast<int>(index(component.dof) % 3);
    if (component.axes == LoadAxes::Local) return geometry.axes.row(axis);
    return Eigen::Vector3d::Unit(axis);
}

} // namespace femoop
