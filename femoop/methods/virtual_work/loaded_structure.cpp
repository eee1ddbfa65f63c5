#include "femoop/methods/virtual_work/loaded_structure.h"

#include <cmath>

namespace femoop::virtual_work {

LocalAxis axis_of(MemberComponent force)
{
    switch (force) {
    case MemberComponent::N: return LocalAxis::x;
    case MemberComponent::Vy: return LocalAxis::y;
    case MemberComponent::Vz: return LocalAxis::z;
    case MemberComponent::T: return LocalAxis::rx;
    case MemberComponent::My: return LocalAxis::ry;
    default: return LocalAxis::rz;
    }
}

LoadedStructure::LoadedStructure(const Loading& loading)
    : structure_(discretise(loading.model)),
      loads_(loads_of(loading.model, structure_)),
      terms_(terms_of(loading.model, loading.load_case).terms),
      result_(loading.results[loading.load_case]),
      magnitudes_(result_.magnitudes())
{}

SpanLoading LoadedStructure::span_loading(MemberId member) const
{
    std::vector<SpanLoading::Scaled> scaled;
    for (const CaseTerms::Term& term : terms_)
        scaled.push_back({.loads = loads_[term.load_case].of(member), .factor = term.factor});
    SpanLoading loading;
    loading.assign(structure_.geometry(member).length, scaled, SpanLoading::no_settling);
    return loading;
}

double force_in_joint(const Curve& curve, const SpanLoading& loading, std::size_t end, MemberComponent force)
{
    // What a point load along an axis adds to the section force there: see Beam::after_jump and Bar.
    const bool is_added = force == MemberComponent::Vy || force == MemberComponent::Vz || force == MemberComponent::My;
    const double sign = is_added ? 1.0 : -1.0;
    const std::size_t axis = index(axis_of(force));
    if (end == 0) return curve.value(force, 0.0) - sign * loading.pieces().front().jump[axis];
    return curve.value(force, curve.length(), Side::Before) + sign * loading.last_jump()[axis];
}

NodeVector in_axes_of(const Discretisation::SupportRow& support, NodeVector v)
{
    const double c = std::cos(support.angle), s = std::sin(support.angle);
    const double x = v[index(Dof::ux)], y = v[index(Dof::uy)];
    v[index(Dof::ux)] = c * x + s * y;
    v[index(Dof::uy)] = c * y - s * x;
    return v;
}

} // namespace femoop::virtual_work
