#include "femoop/analysis/loose_members.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "femoop/analysis/mechanism_words.h"

namespace femoop {

namespace {

/// Calls visit(member, frame) for every member that hangs on a release or spring.
template <class Visit> void visit_jointed_members(const Structure& structure, Visit&& visit)
{
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const MemberExtras* extras = structure.extras_of(MemberId(i));
        if (extras == nullptr || !extras->has_flexible_joint) continue;
        visit(MemberId(i), structure.frame(MemberId(i)));
    }
}

/// A rigid member's foundation holds it against bending as its constraint alone would not.
bool is_held(const Structure& structure, MemberId member, LocalAxis axis)
{
    const bool is_rigid = structure.extras_of(member)->constraint == Constraint::Rigid;
    return is_rigid && structure.properties_of(member).xy.foundation > 0.0 &&
           (axis == LocalAxis::y || axis == LocalAxis::rz);
}

template <AnalysisKind kind>
std::vector<LooseEnd> loose_ends(const Structure& structure, const Assembly<kind>& assembly, MemberId member,
                                 const MemberFrame& frame)
{
    std::vector<LooseEnd> found;
    for (const auto& element : assembly.resisting_elements(member, frame))
        for (const LooseEnd& loose : element.loose_ends())
            if (!is_held(structure, member, loose.axis)) found.push_back(loose);
    return found;
}

/// The free twist of a member, if these loads drive it.
template <class Element>
std::optional<LooseEnd> driven_twist(const Beam& bending, double length, const Element& element,
                                     std::span<const SpanLoad> loads)
{
    if (loads.empty()) return std::nullopt;
    SpanLoading loading;
    const std::array<SpanLoading::Scaled, 1> terms{{{.loads = loads}}};
    bending.cut(loading, length, terms);
    const auto forces = element.rigid_joint_forces(loading);
    for (const LooseEnd& loose : element.loose_ends(forces))
        if (loose.axis == LocalAxis::rx && std::abs(loose.drive) > 1e-9 * forces.cwiseAbs().maxCoeff()) return loose;
    return std::nullopt;
}

} // namespace

template <AnalysisKind kind>
std::vector<Mechanism> loose_members(const Model& model, const Structure& structure, const Assembly<kind>& assembly)
{
    std::vector<Mechanism> mechanisms;
    visit_jointed_members(structure, [&](MemberId member, const MemberFrame& frame) {
        for (const LooseEnd& loose : loose_ends(structure, assembly, member, frame))
            if (loose.axis != LocalAxis::rx) mechanisms.push_back(flying_member(model, structure, member, loose));
    });
    return mechanisms;
}

template <AnalysisKind kind>
std::vector<HeldEnd> hold_loose_own_ends(const Structure& structure, const Equations& equations,
                                         const Assembly<kind>& assembly, SparseMatrix& K)
{
    std::vector<HeldEnd> held;
    visit_jointed_members(structure, [&](MemberId member, const MemberFrame& frame) {
        if (equations.own_end_of().empty() || equations.own_end_of()[member.index] < 0) return;
        const MemberProperties& p = structure.properties_of(member);
        const double stiffness = std::max({p.axial.EA, p.torsion.EA, p.xy.EI, p.xz.EI}) / frame.length;
        for (const LooseEnd& loose : loose_ends(structure, assembly, member, frame)) {
            held.push_back({equations.of_own_end(member, loose.end, loose.axis), stiffness});
            equations.pattern().add_to_diagonal(K, held.back().equation, stiffness);
        }
    });
    return held;
}

template <AnalysisKind kind>
std::vector<Mechanism> driven_twists(const Model& model, const Structure& structure, const Assembly<kind>& assembly,
                                     const std::vector<CaseLoads>& loads)
{
    std::vector<Mechanism> mechanisms;
    const auto twist = [&](MemberId member, const MemberFrame& frame) -> std::optional<LooseEnd> {
        for (const auto& element : assembly.resisting_elements(member, frame))
            for (const CaseLoads& each : loads)
                if (auto driven = driven_twist(structure.properties_of(member).xy, frame.length, element,
                                               each.of(member)))
                    return driven; // the same for every case
        return std::nullopt;
    };
    visit_jointed_members(structure, [&](MemberId member, const MemberFrame& frame) {
        if (const auto driven = twist(member, frame))
            mechanisms.push_back(flying_member(model, structure, member, *driven));
    });
    return mechanisms;
}

template std::vector<Mechanism> loose_members(const Model&, const Structure&, const Assembly<AnalysisKind::Truss2d>&);
template std::vector<HeldEnd> hold_loose_own_ends(const Structure&, const Equations&,
                                                  const Assembly<AnalysisKind::Truss2d>&, SparseMatrix&);
template std::vector<Mechanism> driven_twists(const Model&, const Structure&, const Assembly<AnalysisKind::Truss2d>&,
                                              const std::vector<CaseLoads>&);
template std::vector<Mechanism> loose_members(const Model&, const Structure&, const Assembly<AnalysisKind::Frame2d>&);
template std::vector<HeldEnd> hold_loose_own_ends(const Structure&, const Equations&,
                                                  const Assembly<AnalysisKind::Frame2d>&, SparseMatrix&);
template std::vector<Mechanism> driven_twists(const Model&, const Structure&, const Assembly<AnalysisKind::Frame2d>&,
                                              const std::vector<CaseLoads>&);
template std::vector<Mechanism> loose_members(const Model&, const Structure&, const Assembly<AnalysisKind::Grillage>&);
template std::vector<HeldEnd> hold_loose_own_ends(const Structure&, const Equations&,
                                                  const Assembly<AnalysisKind::Grillage>&, SparseMatrix&);
template std::vector<Mechanism> driven_twists(const Model&, const Structure&, const Assembly<AnalysisKind::Grillage>&,
                                              const std::vector<CaseLoads>&);
template std::vector<Mechanism> loose_members(const Model&, const Structure&, const Assembly<AnalysisKind::Truss3d>&);
template std::vector<HeldEnd> hold_loose_own_ends(const Structure&, const Equations&,
                                                  const Assembly<AnalysisKind::Truss3d>&, SparseMatrix&);
template std::vector<Mechanism> driven_twists(const Model&, const Structure&, const Assembly<AnalysisKind::Truss3d>&,
                                              const std::vector<CaseLoads>&);
template std::vector<Mechanism> loose_members(const Model&, const Structure&, const Assembly<AnalysisKind::Frame3d>&);
template std::vector<HeldEnd> hold_loose_own_ends(const Structure&, const Equations&,
                                                  const Assembly<AnalysisKind::Frame3d>&, SparseMatrix&);
template std::vector<Mechanism> driven_twists(const Model&, const Structure&, const Assembly<AnalysisKind::Frame3d>&,
                                              const std::vector<CaseLoads>&);

} // namespace femoop
