#include "femoop/analysis/loose_members.h"

#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "femoop/analysis/mechanism_words.h"

namespace femoop {

namespace {

/// Calls visit(member, frame, element) for every member that hangs on a release or spring and that no constraint ties.
template <AnalysisKind kind, class Visit>
void visit_jointed_members(const Structure& structure, const Assembly<kind>& assembly, Visit&& visit)
{
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const MemberExtras* extras = structure.extras_of(MemberId(i));
        if (extras == nullptr || !extras->has_flexible_joint || extras->constraint != Constraint::None) continue;
        const MemberFrame frame = structure.frame(MemberId(i));
        visit(MemberId(i), frame, assembly.element(MemberId(i), frame));
    }
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
    visit_jointed_members(structure, assembly, [&](MemberId member, const MemberFrame&, const auto& element) {
        for (const LooseEnd& loose : element.loose_ends())
            if (loose.axis != LocalAxis::rx) mechanisms.push_back(flying_member(model, structure, member, loose));
    });
    return mechanisms;
}

template <AnalysisKind kind>
std::vector<Mechanism> driven_twists(const Model& model, const Structure& structure, const Assembly<kind>& assembly,
                                     const std::vector<CaseLoads>& loads)
{
    std::vector<Mechanism> mechanisms;
    visit_jointed_members(structure, assembly, [&](MemberId member, const MemberFrame& frame, const auto& element) {
        const auto& bending = structure.properties_of(member).xy;
        for (const CaseLoads& each : loads)
            if (const auto twist = driven_twist(bending, frame.length, element, each.of(member))) {
                mechanisms.push_back(flying_member(model, structure, member, *twist));
                return; // the same for every case
            }
    });
    return mechanisms;
}

template std::vector<Mechanism> loose_members(const Model&, const Structure&, const Assembly<AnalysisKind::Truss2d>&);
template std::vector<Mechanism> driven_twists(const Model&, const Structure&, const Assembly<AnalysisKind::Truss2d>&,
                                              const std::vector<CaseLoads>&);
template std::vector<Mechanism> loose_members(const Model&, const Structure&, const Assembly<AnalysisKind::Frame2d>&);
template std::vector<Mechanism> driven_twists(const Model&, const Structure&, const Assembly<AnalysisKind::Frame2d>&,
                                              const std::vector<CaseLoads>&);
template std::vector<Mechanism> loose_members(const Model&, const Structure&, const Assembly<AnalysisKind::Grillage>&);
template std::vector<Mechanism> driven_twists(const Model&, const Structure&, const Assembly<AnalysisKind::Grillage>&,
                                              const std::vector<CaseLoads>&);
template std::vector<Mechanism> loose_members(const Model&, const Structure&, const Assembly<AnalysisKind::Truss3d>&);
template std::vector<Mechanism> driven_twists(const Model&, const Structure&, const Assembly<AnalysisKind::Truss3d>&,
                                              const std::vector<CaseLoads>&);
template std::vector<Mechanism> loose_members(const Model&, const Structure&, const Assembly<AnalysisKind::Frame3d>&);
template std::vector<Mechanism> driven_twists(const Model&, const Structure&, const Assembly<AnalysisKind::Frame3d>&,
                                              const std::vector<CaseLoads>&);

} // namespace femoop
