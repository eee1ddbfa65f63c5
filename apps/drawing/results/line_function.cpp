#include "apps/drawing/results/line_function.h"

namespace drawing {

namespace {

using femoop::MemberComponent;

/// The shear force whose zeros are the extremes of a bending moment.
std::optional<MemberComponent> slope_of(MemberComponent component)
{
    if (component == MemberComponent::Mz) return MemberComponent::Vy;
    if (component == MemberComponent::My) return MemberComponent::Vz;
    return std::nullopt;
}

} // namespace

SectionForce::SectionForce(const femoop::Curve& curve, MemberComponent component)
    : curve_(curve), component_(component), extremes_(curve.extremes(component))
{}

std::optional<double> SectionForce::slope(double x, femoop::Side side) const
{
    const auto shear = slope_of(component_);
    return shear ? std::optional(curve_.value(*shear, x, side)) : std::nullopt;
}

std::vector<double> SectionForce::level_places() const
{
    const auto shear = slope_of(component_);
    return shear ? curve_.zeros(*shear) : std::vector<double>();
}

} // namespace drawing
