#include "femoop/discretisation/discretisation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "femoop/discretisation/taper_of.h"
#include "femoop/geometry/member_geometry.h"
#include "femoop/section/section_properties.h"
#include "femoop/section/tapered_section.h"

namespace femoop {

namespace {

constexpr double standard_gravity = 9.80665; // m/s^2

/// What makes two members alike: their properties are computed once.
struct PropertyKey {
    std::uint32_t material, section;
    bool shear_flexible;
    friend bool operator==(const PropertyKey&, const PropertyKey&) = default;
};
struct PropertyHash {
    std::size_t operator()(const PropertyKey& key) const
    {
        return std::hash<std::uint64_t>()((static_cast<std::uint64_t>(key.material) << 33U) ^
                                          (static_cast<std::uint64_t>(key.section) << 1U) ^
                                          static_cast<std::uint64_t>(key.shear_flexible));
    }
};
constexpr std::uint32_t no_property = 0xffffffffU;

MemberProperties member_properties(const Model& model, const PropertyKey& key, const Section* section)
{
    // A rigid member without material or section shares forces that constraints leave open as if these were 1.
    const double E = key.material == no_property ? 1.0 : model.materials[key.material].E.value();
    const double G = key.material == no_property ? 1.0 : model.materials[key.material].shear_modulus();
    SectionProperties s{.A = 1.0, .Iy = 1.0, .Iz = 1.0, .J = 1.0};
    if (section != nullptr) s = section_properties(*section, model.units);
    const auto flexibility = [&](const std::optional<double>& shear_area) {
        return key.shear_flexible && shear_area ? 1.0 / (G * *shear_area) : 0.0;
    };
    MemberProperties p{.axial = {E * s.A},
                       .torsion = {G * s.J},
                       .xy = {.EI = E * s.Iz, .shear_flexibility = flexibility(s.Asy)},
                       .xz = {.EI = E * s.Iy, .shear_flexibility = flexibility(s.Asz)}};
    if (s.h) {
        p.depth = *s.h;
        p.centroid = s.yc ? *s.yc : 0.5 * *s.h;
    }
    if (key.material != no_property) {
        const Material& material = model.materials[key.material];
        if (material.alpha) p.alpha = *material.alpha;
        if (material.density) p.weight = *material.density * s.A * standard_gravity / metres(model.units.length);
    }
    return p;
}

MemberProperties member_properties(const Model& model, const PropertyKey& key)
{
    return member_properties(model, key, key.section == no_property ? nullptr : &model.sections[key.section]);
}

MemberProperties tapered_properties(const Model& model, const PropertyKey& key, const Member& member)
{
    const Section& section = model[*member.section];
    const double first = member.depths[0], second = member.depths[1];
    const Section at_first_end = at_depth(section, first);
    MemberProperties p = member_properties(model, key, &at_first_end);
    p.xy.taper = taper_of(section, first, second, geometry_of(model, member).length);
    p.axial.taper = p.xy.taper.area;
    return p;
}

JointStiffness joints_of(const MemberEnd& end, bool node_is_hinge, bool is_bar)
{
    JointStiffness joints = rigid_joints;
    if (is_bar) { // its bending and torsion carry nothing: only the axial joint matters
        if (end.release.contains(Dof::ux)) joints[0] = 0.0;
        for (const Spring& spring : end.springs)
            if (spring.dof == Dof::ux) joints[0] = spring.stiffness;
        return joints;
    }
    for (const Dof dof : all_dofs)
        if (end.release.contains(dof) || (node_is_hinge && is_rotation(dof))) joints[index(dof)] = 0.0;
    for (const Spring& spring : end.springs)
        if (joints[index(spring.dof)] != 0.0) joints[index(spring.dof)] = spring.stiffness;
    return joints;
}

bool is_common(const Member& member, const Model& model)
{
    const bool plain_ends = member.start.release.is_empty() && member.end.release.is_empty() &&
                            member.start.springs.empty() && member.end.springs.empty() && member.start.offset.empty() &&
                            member.end.offset.empty();
    const bool plain_nodes = !model[member.nodes[0]].hinge && !model[member.nodes[1]].hinge;
    return plain_ends && plain_nodes && !member.inextensible && !member.rigid && !member.bar && member.up.empty();
}

MemberEndConditions end_conditions_of(const Member& member, const Model& model)
{
    MemberEndConditions end_conditions;
    end_conditions.is_bar = member.bar || is_truss(model.analysis);
    end_conditions.joints = {joints_of(member.start, model[member.nodes[0]].hinge, end_conditions.is_bar),
                             joints_of(member.end, model[member.nodes[1]].hinge, end_conditions.is_bar)};
    for (const JointStiffness& joints : end_conditions.joints)
        for (const double stiffness : joints) end_conditions.has_flexible_joint |= std::isfinite(stiffness);
    end_conditions.offsets = {vector_of(member.start.offset), vector_of(member.end.offset)};
    end_conditions.has_offset = !member.start.offset.empty() || !member.end.offset.empty();
    if (member.rigid) end_conditions.constraint = Constraint::Rigid;
    else if (member.inextensible) end_conditions.constraint = Constraint::Inextensible;
    return end_conditions;
}

/// Adds the members of a model to a structure, each with the properties that it shares with its likes.
class MemberTable {
public:
    MemberTable(const Model& model, Discretisation& structure) : model_(model), structure_(structure) {}

    void add(const Member& member)
    {
        Discretisation::MemberRow row{.nodes = member.nodes, .properties = properties_of(member)};
        for (const NodeId node : member.nodes) structure_.is_attached[node.index] = true;
        if (!is_common(member, model_) || is_truss(model_.analysis)) row.end_conditions = add_end_conditions(member);
        structure_.members.push_back(row);
    }

private:
    std::uint32_t properties_of(const Member& member)
    {
        const PropertyKey key{.material = member.material ? member.material->index : no_property,
                              .section = member.section ? member.section->index : no_property,
                              .shear_flexible = member.theory == BeamTheory::Timoshenko && !member.unshearable};
        if (!member.depths.empty()) {
            structure_.properties.push_back(tapered_properties(model_, key, member));
            return static_cast<std::uint32_t>(structure_.properties.size() - 1);
        }
        if (!known_.empty() && key == last_key_ && !member.foundation) return last_;
        const auto [at, is_new] = known_.try_emplace(key, static_cast<std::uint32_t>(structure_.properties.size()));
        if (is_new) structure_.properties.push_back(member_properties(model_, key));
        last_key_ = key;
        last_ = at->second;
        if (!member.foundation || member.bar || is_truss(model_.analysis)) return last_;
        structure_.properties.push_back(structure_.properties[last_]);
        structure_.properties.back().xy.foundation = *member.foundation;
        return static_cast<std::uint32_t>(structure_.properties.size() - 1);
    }

    std::int32_t add_end_conditions(const Member& member)
    {
        // Truss members are alike but for constraints and axial joints: the plain ones share one entry.
        const bool is_plain_truss = is_truss(model_.analysis) && is_common(member, model_);
        if (is_plain_truss && plain_truss_ >= 0) return plain_truss_;
        structure_.end_conditions.push_back(end_conditions_of(member, model_));
        structure_.up.push_back(vector_of(member.up));
        structure_.has_constraints |= structure_.end_conditions.back().constraint != Constraint::None;
        const auto at = static_cast<std::int32_t>(structure_.end_conditions.size() - 1);
        if (is_plain_truss) plain_truss_ = at;
        return at;
    }

    const Model& model_;
    Discretisation& structure_;
    std::unordered_map<PropertyKey, std::uint32_t, PropertyHash> known_;
    PropertyKey last_key_{};
    std::uint32_t last_ = 0;
    std::int32_t plain_truss_ = -1;
};

Discretisation::SupportRow support_row(const Node& node, NodeId id, AnalysisKind kind)
{
    Discretisation::SupportRow row{
        .node = id, .blocked = node.support->blocked(kind), .angle = node.support->angle * std::numbers::pi / 180.0};
    for (const Spring& spring : node.support->springs) row.springs[index(spring.dof)] = spring.stiffness;
    return row;
}

} // namespace

double Discretisation::size() const
{
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& position : positions) box.extend(position);
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

MemberData Discretisation::data(MemberId member) const
{
    const MemberRow& row = members[member.index];
    MemberData data{.nodes = row.nodes,
                    .positions = {&positions[row.nodes[0].index], &positions[row.nodes[1].index]},
                    .properties = &properties[row.properties]};
    if (row.end_conditions < 0) return data;
    data.end_conditions = &end_conditions[static_cast<std::size_t>(row.end_conditions)];
    data.up = &up[static_cast<std::size_t>(row.end_conditions)];
    return data;
}

Discretisation discretise(const Model& model)
{
    Discretisation structure;
    structure.kind = model.analysis;
    const std::size_t n = model.nodes.size();
    structure.positions.reserve(n);
    structure.support_of_node.assign(n, -1);
    structure.is_attached.assign(n, false);
    for (std::size_t i = 0; i < n; ++i) {
        structure.positions.push_back(position_of(model, NodeId(i)));
        if (!model.nodes[i].support) continue;
        structure.support_of_node[i] = static_cast<std::int32_t>(structure.supports.size());
        structure.supports.push_back(support_row(model.nodes[i], NodeId(i), model.analysis));
    }
    structure.members.reserve(model.members.size());
    MemberTable table(model, structure);
    for (const Member& member : model.members) table.add(member);
    return structure;
}

} // namespace femoop
