#include "femoop/load/span_loads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <variant>

#include "femoop/load/load_components.h"

namespace femoop {

namespace {

constexpr double round_off = 1e-14; // of the larger of two temperatures whose mean is 0

/// A load's components as one vector along global or member axes.
struct LoadVector {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();

    void set(Dof dof, double value)
    {
        const auto i = static_cast<int>(index(dof));
        (i < 3 ? force[i] : moment[i - 3]) = value;
    }
    void turn(const Eigen::Matrix3d& axes)
    {
        force = axes * force;
        moment = axes * moment;
    }
    double operator[](std::size_t axis) const
    {
        const auto i = static_cast<int>(axis);
        return i < 3 ? force[i] : moment[i - 3];
    }
};

/// One load after the other as span loads of one member.
class SpanLoadReader {
public:
    SpanLoadReader(const MemberGeometry& geometry, const MemberProperties& properties)
        : geometry_(geometry), properties_(properties)
    {}

    std::vector<SpanLoad> loads() { return std::move(loads_); }

    /// Those that act at the same places are turned into the member's axes as one vector.
    void add(std::span<const LoadComponent> components)
    {
        while (!components.empty()) {
            const auto acts_elsewhere = [&first = components.front()](const LoadComponent& other) {
                return other.from != first.from || other.to != first.to;
            };
            const auto next = std::ranges::find_if(components, acts_elsewhere);
            const auto n = static_cast<std::size_t>(next - components.begin());
            add_together(components.first(n));
            components = components.subspan(n);
        }
    }

    void add(const TemperatureLoad& load)
    {
        const double difference = load.top - load.bottom;
        const double gradient = difference == 0.0 ? 0.0 : difference / properties_.depth;
        const double largest = std::max(std::abs(load.top.value()), std::abs(load.bottom.value()));
        const double mean = load.bottom + gradient * properties_.centroid;
        add_strain(std::abs(mean) > round_off * largest ? properties_.alpha * mean : 0.0,
                   -properties_.alpha * gradient);
    }

    void add(const Misfit& load) { add_strain(load.elongation / geometry_.length, 0.0); }

    void add_weight(Dof up, double q)
    {
        const double L = geometry_.length;
        const double at_end = q * (1.0 + properties_.axial.taper * L);
        add_together(std::array{LoadComponent{.dof = up, .from = 0.0, .to = L, .start = -q, .end = -at_end}});
    }

private:
    /// How much of a metre along the member shows square to a global axis.
    double projection(Dof dof) const
    {
        const double cosine = geometry_.axes(0, static_cast<int>(index(dof) % 3));
        return std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    }

    /// \pre not empty, all of one kind, at the same places and along the same axes
    void add_together(std::span<const LoadComponent> components)
    {
        LoadVector start, end;
        for (const LoadComponent& component : components) {
            const double share = component.is_projected ? projection(component.dof) : 1.0;
            start.set(component.dof, share * component.start);
            end.set(component.dof, share * component.end);
        }
        const LoadComponent& first = components.front();
        if (first.axes == LoadAxes::Global) {
            start.turn(geometry_.axes);
            end.turn(geometry_.axes);
        }
        const bool is_line = first.kind == LoadComponent::Kind::Line;
        for (std::size_t axis = 0; axis < n_local_axes; ++axis)
            if (start[axis] != 0.0 || end[axis] != 0.0)
                loads_.push_back({.kind = is_line ? SpanLoad::Kind::Distributed : SpanLoad::Kind::Point,
                                  .axis = static_cast<LocalAxis>(axis),
                                  .from = first.from,
                                  .to = first.to,
                                  .start = start[axis],
                                  .end = end[axis]});
    }

    void add_strain(double strain, double curvature)
    {
        loads_.push_back({.kind = SpanLoad::Kind::Strain, .start = strain, .end = curvature});
    }

    const MemberGeometry& geometry_;
    const MemberProperties& properties_;
    std::vector<SpanLoad> loads_;
};

} // namespace

std::vector<SpanLoad> span_loads(const MemberLoad& load, const MemberGeometry& geometry,
                                 const MemberProperties& properties)
{
    SpanLoadReader reader(geometry, properties);
    reader.add(components_of(load, geometry.length));
    if (const auto* const heat = std::get_if<TemperatureLoad>(&load.load)) reader.add(*heat);
    if (const auto* const misfit = std::get_if<Misfit>(&load.load)) reader.add(*misfit);
    return reader.loads();
}

std::vector<SpanLoad> self_weight(double factor, AnalysisKind kind, const MemberGeometry& geometry,
                                  const MemberProperties& properties)
{
    SpanLoadReader reader(geometry, properties);
    reader.add_weight(is_plane(kind) ? Dof::uy : Dof::uz, factor * properties.weight);
    return reader.loads();
}

} // namespace femoop
