#include "femoop/plane/model/plane_model.h"

namespace femoop::plane {

DofSet PlaneSupport::blocked() const
{
    switch (kind) {
    case PlaneSupportKind::Fixed:
    case PlaneSupportKind::Pin: return {Dof::ux, Dof::uy};
    case PlaneSupportKind::Roller:
    case PlaneSupportKind::Symmetry: return {Dof::uy};
    case PlaneSupportKind::Custom: break;
    }
    return fixed;
}

const std::string& PlaneModel::case_name(CaseId id) const
{
    return id.index < load_cases.size() ? load_cases[id.index].id : combinations[id.index - load_cases.size()].id;
}

std::optional<CaseId> PlaneModel::find_case(std::string_view id) const
{
    for (std::size_t i = 0; i < n_cases(); ++i)
        if (case_name(CaseId(i)) == id) return CaseId(i);
    return std::nullopt;
}

Formulation PlaneModel::formulation(RegionId region) const
{
    const std::optional<Formulation>& own = regions[region.index].mesh.formulation;
    return own ? *own : mesh.formulation.value_or(Formulation::Standard);
}

double PlaneModel::thickness(RegionId region) const
{
    const std::optional<Quantity>& own = regions[region.index].thickness;
    return own ? own->value() : 1.0;
}

std::string_view name(StressState analysis)
{
    switch (analysis) {
    case StressState::PlaneStress: return "plane_stress";
    case StressState::PlaneStrain: return "plane_strain";
    case StressState::Axisymmetric: return "axisymmetric";
    case StressState::Solid: break;
    }
    return "solid";
}

std::string_view name(Formulation formulation)
{
    switch (formulation) {
    case Formulation::Standard: return "standard";
    case Formulation::Reduced: return "reduced";
    case Formulation::BBar: return "b_bar";
    case Formulation::Incompatible: break;
    }
    return "incompatible";
}

bool has_formulation(ShapeKind shape, Formulation formulation, StressState analysis)
{
    switch (formulation) {
    case Formulation::Standard: return true;
    case Formulation::Reduced: return shape == ShapeKind::Q8;
    case Formulation::BBar: return shape == ShapeKind::Q4 && analysis != StressState::PlaneStress;
    case Formulation::Incompatible: break;
    }
    return shape == ShapeKind::Q4 && analysis != StressState::Axisymmetric;
}

} // namespace femoop::plane
