#include "femoop/result/components.h"

namespace femoop {

std::vector<MemberComponent> section_force_components(AnalysisKind kind)
{
    using enum MemberComponent;
    if (is_3d(kind)) return {N, Vy, Vz, T, My, Mz};
    if (kind == AnalysisKind::Grillage) return {Vy, Mz, T};
    return {N, Vy, Mz};
}

std::vector<MemberComponent> local_displacement_components(AnalysisKind kind)
{
    using enum MemberComponent;
    if (is_3d(kind)) return {u, v, w};
    if (kind == AnalysisKind::Grillage) return {v};
    return {u, v};
}

std::vector<MemberComponent> member_components(AnalysisKind kind)
{
    std::vector<MemberComponent> all = section_force_components(kind);
    for (const MemberComponent component : local_displacement_components(kind)) all.push_back(component);
    return all;
}

double value(const Station& station, MemberComponent component)
{
    const SectionForces& forces = station.forces;
    const LocalDisplacement& u = station.displacement;
    switch (component) {
    case MemberComponent::N: return forces.N;
    case MemberComponent::Vy: return forces.Vy;
    case MemberComponent::Vz: return forces.Vz;
    case MemberComponent::T: return forces.T;
    case MemberComponent::My: return forces.My;
    case MemberComponent::Mz: return forces.Mz;
    case MemberComponent::u: return u.u;
    case MemberComponent::v: return u.v;
    case MemberComponent::w: break;
    }
    return u.w;
}

std::vector<Dof> dof_list(AnalysisKind kind)
{
    std::vector<Dof> list;
    for (const Dof dof : all_dofs)
        if (dofs(kind).contains(dof)) list.push_back(dof);
    return list;
}

std::vector<Dof> equilibrium_dofs(AnalysisKind kind)
{
    if (is_3d(kind)) return dof_list(AnalysisKind::Frame3d);
    if (kind == AnalysisKind::Grillage) return dof_list(AnalysisKind::Grillage);
    return dof_list(AnalysisKind::Frame2d);
}

} // namespace femoop
