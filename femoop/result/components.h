#pragma once

#include <string_view>
#include <vector>

#include "femoop/model/dof.h"
#include "femoop/model/expected.h"
#include "femoop/result/curve.h"

namespace femoop {

/// The section forces that a member of this model can carry, in the order in which they are printed:
/// N V M in plane models, V M T in a grillage, N Vy Vz T My Mz in space. Trusses carry span loads as simple
/// beams, so they have V and M too.
std::vector<MemberComponent> section_force_components(AnalysisKind kind);

/// The local displacements of a member of this model: u v in plane models, v in a grillage, u v w in space.
std::vector<MemberComponent> local_displacement_components(AnalysisKind kind);

/// Both, section forces first.
std::vector<MemberComponent> member_components(AnalysisKind kind);

double value(const Station& station, MemberComponent component);

constexpr bool is_moment(MemberComponent component)
{
    return component == MemberComponent::T || component == MemberComponent::My || component == MemberComponent::Mz;
}
constexpr bool is_displacement(MemberComponent component)
{
    return component == MemberComponent::u || component == MemberComponent::v || component == MemberComponent::w;
}

/// The degrees of freedom of a node, in printing order.
std::vector<Dof> dof_list(AnalysisKind kind);

/// The equations of equilibrium of the structure as a whole, named by the motion that each force works on:
/// ux uy rz (fx fy mz) in plane models, uz rx ry in a grillage, all six in space.
std::vector<Dof> equilibrium_dofs(AnalysisKind kind);

} // namespace femoop
