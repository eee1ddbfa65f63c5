#include "femoop/methods/cross/member_action.h"

#include <cmath>

#include "femoop/element/member_element.h"

namespace femoop::cross {

namespace {

using Element = MemberElement<AnalysisKind::Frame2d>;
constexpr int x1 = 0, y1 = 1, th1 = 2, x2 = 3, y2 = 4, th2 = 5; // of an element's displacements

bool is_rigid(const MemberEndConditions* end_conditions, LocalAxis axis)
{
    return end_conditions == nullptr ||
           (std::isinf(end_conditions->joints[0][index(axis)]) && std::isinf(end_conditions->joints[1][index(axis)]));
}

/// One member of the structure in the case.
class Reader {
public:
    Reader(const Discretisation& structure, MemberId member)
        : structure_(structure),
          member_(member),
          geometry_(structure.geometry(member)),
          end_conditions_(structure.end_conditions_of(member))
    {}

    LoadedMember read(const SpanLoading& loading) const
    {
        LoadedMember loaded;
        loaded.action = unloaded();
        loaded.elongation = loading.strain() * geometry_.length;
        const Element axial = element({Action::Axial});
        const auto fx = axial.local_fixed_end_forces(loading.without_strain());
        loaded.action.fx = {fx[x1], fx[x2]};
        if (is_bar()) {
            const auto f = axial.simple_span_forces(loading);
            loaded.bar_force = {f.head<2>(), f.segment<2>(3)};
            return loaded;
        }
        const Element bending = element({Action::BendingXY});
        const auto f = bending.local_fixed_end_forces(loading);
        loaded.action.f = arms().transpose() * Eigen::Vector4d(f[y1], f[th1], f[y2], f[th2]);
        loaded.can_overhang = !loaded.action.has_foundation && is_rigid_throughout();
        return loaded;
    }

private:
    bool is_bar() const { return end_conditions_ != nullptr && end_conditions_->is_bar; }
    bool is_rigid_throughout() const { return end_conditions_ == nullptr || !end_conditions_->has_flexible_joint; }

    Element element(ActionSet actions) const
    {
        return {structure_.properties_of(member_), geometry_, end_conditions_, actions};
    }

    MemberAction unloaded() const
    {
        MemberAction action;
        action.nodes = structure_.members[member_.index].nodes;
        action.x = geometry_.axes.row(0).head<2>();
        action.y = geometry_.axes.row(1).head<2>();
        const Eigen::Vector3d chord = structure_.positions[action.nodes[1].index] -
                                      structure_.positions[action.nodes[0].index];
        action.length = chord.norm();
        action.is_axially_rigid = is_rigid(end_conditions_, LocalAxis::x);
        if (is_bar()) return action;
        const MemberProperties& properties = structure_.properties_of(member_);
        action.has_foundation = properties.xy.foundation > 0.0;
        action.is_tapered = !properties.xy.taper.is_prismatic();
        action.EI_over_L = properties.xy.EI / geometry_.length;
        const auto K = element({Action::BendingXY}).local_stiffness();
        const std::array rows{y1, th1, y2, th2};
        action.K = arms().transpose() * K(rows, rows) * arms();
        return action;
    }

    /// The member's end displacements from those of its nodes, through arms along its axis.
    Eigen::Matrix4d arms() const
    {
        Eigen::Matrix4d B = Eigen::Matrix4d::Identity();
        if (end_conditions_ == nullptr || !end_conditions_->has_offset) return B;
        B(0, 1) = geometry_.axes.row(0).dot(end_conditions_->offsets[0]);
        B(2, 3) = geometry_.axes.row(0).dot(end_conditions_->offsets[1]);
        return B;
    }

    const Discretisation& structure_;
    MemberId member_;
    MemberGeometry geometry_;
    const MemberEndConditions* end_conditions_;
};

} // namespace

std::vector<LoadedMember> loaded_members(const Discretisation& structure, const std::vector<CaseLoads>& loads,
                                         const CaseTerms& terms)
{
    std::vector<LoadedMember> members;
    members.reserve(structure.members.size());
    SpanLoading loading;
    std::vector<SpanLoading::Scaled> scaled;
    for (std::size_t i = 0; i < structure.members.size(); ++i) {
        const MemberId member(i);
        scaled.clear();
        for (const CaseTerms::Term& term : terms.terms)
            scaled.push_back({.loads = loads[term.load_case].of(member), .factor = term.factor});
        structure.properties_of(member).xy.cut(loading, structure.geometry(member).length, scaled);
        members.push_back(Reader(structure, member).read(loading));
    }
    return members;
}

CaseForces case_forces(const Discretisation& structure, const std::vector<CaseLoads>& loads, const CaseTerms& terms)
{
    const std::size_t n = structure.positions.size();
    CaseForces forces{.node_force = {n, Eigen::Vector2d::Zero()},
                      .node_moment = std::vector<double>(n, 0.0),
                      .settlement = {n, Eigen::Vector2d::Zero()},
                      .turn = std::vector<double>(n, 0.0)};
    for (const CaseTerms::Term& term : terms.terms) {
        const CaseLoads& load = loads[term.load_case];
        for (const CaseLoads::OnNode& on : load.nodes) {
            forces.node_force[on.node.index] += term.factor * Eigen::Vector2d(on.value[0], on.value[1]);
            forces.node_moment[on.node.index] += term.factor * on.value[index(Dof::rz)];
        }
        for (const CaseLoads::OnNode& on : load.settlements) {
            forces.settlement[on.node.index] += term.factor * Eigen::Vector2d(on.value[0], on.value[1]);
            forces.turn[on.node.index] += term.factor * on.value[index(Dof::rz)];
        }
    }
    return forces;
}

} // namespace femoop::cross
