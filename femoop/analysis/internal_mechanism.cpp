#include "femoop/analysis/internal_mechanism.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "femoop/analysis/mechanism_report.h"

namespace femoop {

namespace {

/// Calls visit(member, geometry) for every member that hangs on a release or spring.
template <class Visit> void visit_jointed_members(const Discretisation& structure, Visit&& visit)
{
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const MemberEndConditions* end_conditions = structure.end_conditions_of(MemberId(i));
        if (end_conditions == nullptr || !end_conditions->has_flexible_joint) continue;
        visit(MemberId(i), structure.geometry(MemberId(i)));
    }
}

/// A rigid member's foundation holds it against bending as its constraint alone would not.
bool is_held(const Discretisation& structure, MemberId member, LocalAxis axis)
{
    const bool is_rigid = structure.end_conditions_of(member)->constraint == Constraint::Rigid;
    return is_rigid && structure.properties_of(member).xy.foundation > 0.0 &&
           (axis == LocalAxis::y || axis == LocalAxis::rz);
}

template <AnalysisKind kind>
std::vector<InternalMechanism> internal_mechanisms(const Discretisation& structure, const Assembly<kind>& assembly,
                                                   MemberId member, const MemberGeometry& geometry)
{
    std::vector<InternalMechanism> found;
    for (const auto& element : assembly.resisting_elements(member, geometry))
        for (const InternalMechanism& loose : element.internal_mechanisms())
            if (!is_held(structure, member, loose.axis)) found.push_back(loose);
    return found;
}

/// The free twist of a member, if these loads drive it.
template <class Element>
std::optional<InternalMechanism> loaded_twist(const Beam& bending, double length, const Element& element,
                                              std::span<const SpanLoad> loads)
{
    if (loads.empty()) return std::nullopt;
    SpanLoading loading;
    const std::array<SpanLoading::Scaled, 1> terms{{{.loads = loads}}};
    bending.cut(loading, length, terms);
    const auto forces = element.rigid_joint_forces(loading);
    for (const InternalMechanism& loose : element.internal_mechanisms(forces))
        if (loose.axis == LocalAxis::rx && std::abs(loose.drive) > 1e-9 * forces.cwiseAbs().maxCoeff()) return loose;
    return std::nullopt;
}

} // namespace

template <AnalysisKind kind>
std::vector<Mechanism> internal_mechanisms_of(const Model& model, const Discretisation& structure,
                                              const Assembly<kind>& assembly)
{
    std::vector<Mechanism> mechanisms;
    visit_jointed_members(structure, [&](MemberId member, const MemberGeometry& geometry) {
        for (const InternalMechanism& loose : internal_mechanisms(structure, assembly, member, geometry))
            if (loose.axis != LocalAxis::rx) mechanisms.push_back(member_mechanism(model, structure, member, loose));
    });
    return mechanisms;
}

template <AnalysisKind kind>
std::vector<MemberEndRestraint> restrain_member_ends(const Discretisation& structure, const Equations& equations,
                                                     const Assembly<kind>& assembly, SparseMatrix& K)
{
    std::vector<MemberEndRestraint> held;
    visit_jointed_members(structure, [&](MemberId member, const MemberGeometry& geometry) {
        if (equations.member_end_dofs_of().empty() || equations.member_end_dofs_of()[member.index] < 0) return;
        const MemberProperties& p = structure.properties_of(member);
        const double stiffness = std::max({p.axial.EA, p.torsion.EA, p.xy.EI, p.xz.EI}) / geometry.length;
        for (const InternalMechanism& loose : internal_mechanisms(structure, assembly, member, geometry)) {
            held.push_back({equations.of_member_end(member, loose.end, loose.axis), stiffness});
            equations.pattern().add_to_diagonal(K, held.back().equation, stiffness);
        }
    });
    return held;
}

template <AnalysisKind kind>
std::vector<Mechanism> loaded_twists(const Model& model, const Discretisation& structure,
                                     const Assembly<kind>& assembly, const std::vector<CaseLoads>& loads)
{
    std::vector<Mechanism> mechanisms;
    const auto twist = [&](MemberId member, const MemberGeometry& geometry) -> std::optional<InternalMechanism> {
        for (const auto& element : assembly.resisting_elements(member, geometry))
            for (const CaseLoads& each : loads)
                if (auto driven = loaded_twist(structure.properties_of(member).xy, geometry.length, element,
                                               each.of(member)))
                    return driven; // the same for every case
        return std::nullopt;
    };
    visit_jointed_members(structure, [&](MemberId member, const MemberGeometry& geometry) {
        if (const auto driven = twist(member, geometry))
            mechanisms.push_back(member_mechanism(model, structure, member, *driven));
    });
    return mechanisms;
}

template std::vector<Mechanism> internal_mechanisms_of(const Model&, const Discretisation&,
                                                       const Assembly<AnalysisKind::Truss2d>&);
template std::vector<MemberEndRestraint> restrain_member_ends(const Discretisation&, const Equations&,
                                                              const Assembly<AnalysisKind::Truss2d>&, SparseMatrix&);
template std::vector<Mechanism> loaded_twists(const Model&, const Discretisation&,
                                              const Assembly<AnalysisKind::Truss2d>&, const std::vector<CaseLoads>&);
template std::vector<Mechanism> internal_mechanisms_of(const Model&, const Discretisation&,
                                                       const Assembly<AnalysisKind::Frame2d>&);
template std::vector<MemberEndRestraint> restrain_member_ends(const Discretisation&, const Equations&,
                                                              const Assembly<AnalysisKind::Frame2d>&, SparseMatrix&);
template std::vector<Mechanism> loaded_twists(const Model&, const Discretisation&,
                                              const Assembly<AnalysisKind::Frame2d>&, const std::vector<CaseLoads>&);
template std::vector<Mechanism> internal_mechanisms_of(const Model&, const Discretisation&,
                                                       const Assembly<AnalysisKind::Grillage>&);
template std::vector<MemberEndRestraint> restrain_member_ends(const Discretisation&, const Equations&,
                                                              const Assembly<AnalysisKind::Grillage>&, SparseMatrix&);
template std::vector<Mechanism> loaded_twists(const Model&, const Discretisation&,
                                              const Assembly<AnalysisKind::Grillage>&, const std::vector<CaseLoads>&);
template std::vector<Mechanism> internal_mechanisms_of(const Model&, const Discretisation&,
                                                       const Assembly<AnalysisKind::Truss3d>&);
template std::vector<MemberEndRestraint> restrain_member_ends(const Discretisation&, const Equations&,
                                                              const Assembly<AnalysisKind::Truss3d>&, SparseMatrix&);
template std::vector<Mechanism> loaded_twists(const Model&, const Discretisation&,
                                              const Assembly<AnalysisKind::Truss3d>&, const std::vector<CaseLoads>&);
template std::vector<Mechanism> internal_mechanisms_of(const Model&, const Discretisation&,
                                                       const Assembly<AnalysisKind::Frame3d>&);
template std::vector<MemberEndRestraint> restrain_member_ends(const Discretisation&, const Equations&,
                                                              const Assembly<AnalysisKind::Frame3d>&, SparseMatrix&);
template std::vector<Mechanism> loaded_twists(const Model&, const Discretisation&,
                                              const Assembly<AnalysisKind::Frame3d>&, const std::vector<CaseLoads>&);

} // namespace femoop
