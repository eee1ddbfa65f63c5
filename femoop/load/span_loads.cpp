#include "femoop/load/span_loads.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "femoop/load/place_along.h"

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

    void add(const DistributedLoad& load)
    {
        LoadVector start, end;
        for (const DistributedLoad::Value& value : load.values) {
            const double share = load.projected ? projection(value.dof) : 1.0;
            start.set(value.dof, share * value.start);
            end.set(value.dof, share * (value.end ? *value.end : value.start));
        }
        if (load.axes == LoadAxes::Global) {
            start.turn(geometry_.axes);
            end.turn(geometry_.axes);
        }
        const double L = geometry_.length;
        add_distributed(start, end, load.from ? along(*load.from, L) : 0.0, load.to ? along(*load.to, L) : L);
    }

    void add(const PointLoad& load) { add_point(load.components, load.axes, along(load.at, geometry_.length)); }

    void add(const EndLoads& load)
    {
        add_point(load.start, load.axes, 0.0);
        add_point(load.end, load.axes, geometry_.length);
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
        LoadVector weight;
        weight.set(up, -q);
        weight.turn(geometry_.axes);
        add_distributed(weight, weight, 0.0, geometry_.length);
    }

private:
    /// How much of a metre along the member shows square to a global axis.
    double projection(Dof dof) const
    {
        const double cosine = geometry_.axes(0, static_cast<int>(index(dof) % 3));
        return std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
    }

    void add_distributed(const LoadVector& start, const LoadVector& end, double from, double to)
    {
        for (std::size_t axis = 0; axis < n_local_axes; ++axis)
            if (start[axis] != 0.0 || end[axis] != 0.0)
                loads_.push_back({.kind = SpanLoad::Kind::Distributed,
                                  .axis = static_cast<LocalAxis>(axis),
                                  .from = from,
                                  .to = to,
                                  .start = start[axis],
                                  .end = end[axis]});
    }

    void add_point(const std::vector<Component>& components, LoadAxes axes, double at)
    {
        LoadVector load;
        for (const Component& component : components) load.set(component.dof, component.value);
        if (axes == LoadAxes::Global) load.turn(geometry_.axes);
        for (std::size_t axis = 0; axis < n_local_axes; ++axis)
            if (load[axis] != 0.0)
                loads_.push_back({.kind = SpanLoad::Kind::Point,
                                  .axis = static_cast<LocalAxis>(axis),
                                  .from = at,
                                  .to = at,
                                  .start = load[axis],
                                  .end = 0.0});
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
    std::visit([&](const auto& each) { reader.add(each); }, load.load);
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
