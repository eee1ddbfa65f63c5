#include "apps/frame/view/results/case_numbers.h"

#include "apps/frame/view/sketch/scene.h"

#include <algorithm>
#include <cmath>

namespace frame {

using femoop::MemberComponent;
using ui::Measure;

namespace {

constexpr double rounding = 1e-9; // of the largest value of its kind

double largest(const femoop::Curve& curve, std::initializer_list<MemberComponent> components)
{
    double most = 0.0;
    for (const MemberComponent component : components) {
        const femoop::Extremes e = curve.extremes(component);
        most = std::max({most, std::abs(e.max.value), std::abs(e.min.value)});
    }
    return most;
}

double largest_translation(const femoop::NodeVector& u)
{
    return std::max({std::abs(u[0]), std::abs(u[1]), std::abs(u[2])});
}

} // namespace

CaseNumbers::CaseNumbers(const femoop::CaseResult& result, const StructureShape& shape, const ui::DisplayUnits& units)
    : units_(units)
{
    using enum MemberComponent;
    double force = 0.0, moment = 0.0, displacement = 0.0;
    for (std::size_t i = 0; i < shape.members.size(); ++i) {
        const femoop::Curve curve = result.curve(femoop::MemberId{i});
        force = std::max(force, largest(curve, {N, Vy, Vz}));
        moment = std::max(moment, largest(curve, {T, My, Mz}));
        displacement = std::max(displacement, largest(curve, {v, w}));
    }
    for (std::size_t i = 0; i < shape.nodes.size(); ++i)
        displacement = std::max(displacement, largest_translation(result.displacement(femoop::NodeId{i})));
    least_ = {{Measure::Force, rounding * std::max(force, moment / shape.size)},
              {Measure::Moment, rounding * std::max(moment, force * shape.size)},
              {Measure::Displacement, rounding * displacement},
              {Measure::Rotation, rounding * displacement / shape.size}};
}

double CaseNumbers::without_rounding(double value, Measure measure) const
{
    const auto least = least_.find(measure);
    return least != least_.end() && std::abs(value) <= least->second ? 0.0 : value;
}

std::string CaseNumbers::number(double value, Measure measure) const
{
    return with_minus(units_.number(without_rounding(value, measure), measure));
}

std::string CaseNumbers::text(double value, Measure measure) const
{
    return with_minus(units_.text(without_rounding(value, measure), measure));
}

} // namespace frame
