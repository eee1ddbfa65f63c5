#include "femoop/analysis/member_mechanism.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace femoop {

namespace {

/// Calls visit(member) for every member that hangs on a release or spring.
template <class Visit> void visit_jointed_members(const Discretisation& structure, Visit&& visit)
{
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const MemberEndConditions* end_conditions = structure.end_conditions_of(MemberId(i));
        if (end_conditions != nullptr && end_conditions->has_flexible_joint) visit(MemberId(i));
    }
}

/// A rigid member's foundation holds it against bending as its constraint alone would not.
bool is_held(const Discretisation& structure, MemberId member, LocalAxis axis)
{
    const bool is_rigid = structure.end_conditions_of(member)->constraint == Constraint::Rigid;
    return is_rigid && structure.properties_of(member).xy.foundation > 0.0 &&
           (axis == LocalAxis::y || axis == LocalAxis::rz);
}

std::vector<InternalMechanism> mechanisms_of(const Assembler& assembler, MemberId member)
{
    std::vector<InternalMechanism> found = assembler.elements()[member].internal_mechanisms();
    std::erase_if(found, [&](const InternalMechanism& mechanism) {
        return is_held(assembler.structure(), member, mechanism.axis);
    });
    return found;
}

} // namespace

std::vector<LooseMember> loose_members(const Assembler& assembler)
{
    std::vector<LooseMember> loose;
    visit_jointed_members(assembler.structure(), [&](MemberId member) {
        for (InternalMechanism& mechanism : mechanisms_of(assembler, member))
            if (mechanism.axis != LocalAxis::rx) loose.push_back({member, std::move(mechanism)});
    });
    return loose;
}

std::vector<MemberEndRestraint> restrain_member_ends(const Assembler& assembler, SparseMatrix& K)
{
    const Discretisation& structure = assembler.structure();
    const Equations& equations = assembler.equations();
    std::vector<MemberEndRestraint> restraints;
    visit_jointed_members(structure, [&](MemberId member) {
        if (equations.member_end_dofs_of().empty() || equations.member_end_dofs_of()[member.index] < 0) return;
        const MemberProperties& p = structure.properties_of(member);
        const double stiffness = std::max({p.axial.EA, p.torsion.EA, p.xy.EI, p.xz.EI}) /
                                 structure.geometry(member).length;
        for (const InternalMechanism& mechanism : mechanisms_of(assembler, member)) {
            restraints.push_back({equations.of_member_end(member, mechanism.end, mechanism.axis), stiffness});
            equations.pattern().add_to_diagonal(K, restraints.back().equation, stiffness);
        }
    });
    return restraints;
}

std::vector<LooseMember> loaded_twists(const Assembler& assembler, const std::vector<CaseLoads>& loads)
{
    std::vector<LooseMember> twisted;
    const auto twist = [&](MemberId member) -> std::optional<InternalMechanism> {
        for (const CaseLoads& each : loads)
            if (auto loaded = assembler.elements()[member].loaded_twist(each.of(member)))
                return loaded; // the same for every case
        return std::nullopt;
    };
    visit_jointed_members(assembler.structure(), [&](MemberId member) {
        if (auto loaded = twist(member)) twisted.push_back({member, std::move(*loaded)});
    });
    return twisted;
}

} // namespace femoop
