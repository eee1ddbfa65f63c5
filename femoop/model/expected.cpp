#include "femoop/model/expected.h"

#include <array>
#include <utility>

#include "femoop/model/quantity/dof_dimension.h"

namespace femoop {

namespace {

using ComponentNames = std::array<std::string_view, n_member_components>;
constexpr ComponentNames names_in_space{"N", "Vy", "Vz", "T", "My", "Mz", "u", "v", "w"};
constexpr ComponentNames names_plane{"N", "V", "", "", "", "M", "u", "v", ""};
constexpr ComponentNames names_grillage{"", "V", "", "T", "", "M", "", "v", ""};

const ComponentNames& component_names(AnalysisKind kind)
{
    if (is_3d(kind)) return names_in_space;
    return kind == AnalysisKind::Grillage ? names_grillage : names_plane;
}

bool is_moment(MemberComponent component)
{
    return component == MemberComponent::T || component == MemberComponent::My || component == MemberComponent::Mz;
}

bool is_displacement(MemberComponent component)
{
    return component == MemberComponent::u || component == MemberComponent::v || component == MemberComponent::w;
}

} // namespace

std::string_view name(MemberComponent component, AnalysisKind kind)
{
    return component_names(kind)[static_cast<std::size_t>(component)];
}

std::optional<MemberComponent> find_member_component(std::string_view text, AnalysisKind kind)
{
    if (text.empty()) return std::nullopt;
    for (const MemberComponent component : all_member_components)
        if (name(component, kind) == text) return component;
    return std::nullopt;
}

Dimension dimension_of(const Expected& check)
{
    switch (check.quantity) {
    case ExpectedQuantity::LoadFactor:
    case ExpectedQuantity::CollapseFactor: return dimension::none;
    case ExpectedQuantity::Frequency: return dimension::frequency;
    case ExpectedQuantity::Reaction: return force_dimension(check.dof.value_or(Dof::ux));
    default: break;
    }
    if (!check.component) return displacement_dimension(check.dof.value_or(Dof::ux));
    if (is_displacement(*check.component)) return dimension::length;
    return is_moment(*check.component) ? dimension::moment : dimension::force;
}

} // namespace femoop
