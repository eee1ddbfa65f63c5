#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "femoop/geometry/member_geometry.h"
#include "femoop/model/check/checker.h"
#include "femoop/model/check/name_table.h"
#include "femoop/model/quantity/dof_dimension.h"
#include "femoop/model/quantity/number_text.h"

namespace femoop {

namespace {

/// What the analysis needs to know of a member's section.
struct Need {
    std::string_view key;
    std::optional<Quantity> Section::*value;
};
constexpr Need area{"A", &Section::A}, Iz{"Iz", &Section::Iz}, Iy{"Iy", &Section::Iy}, J{"J", &Section::J};

std::vector<Need> needs(AnalysisKind kind, const Member& member)
{
    if (member.bar && kind != AnalysisKind::Grillage) return {area};
    switch (kind) {
    case AnalysisKind::Truss2d:
    case AnalysisKind::Truss3d: break;
    case AnalysisKind::Frame2d: return {area, Iz};
    case AnalysisKind::Grillage: return {Iz, J};
    case AnalysisKind::Frame3d: return {area, Iy, Iz, J};
    }
    return {area};
}

std::array<double, 3> point(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

std::string_view end_name(bool is_start) { return is_start ? "start" : "end"; }

} // namespace

void Checker::check_ids()
{
    check_names("materials", model_.materials, unreadable_.materials);
    check_names("sections", model_.sections, unreadable_.sections);
    check_names("nodes", model_.nodes, unreadable_.nodes);
    check_names("members", model_.members, unreadable_.members);
    std::vector<Entry> cases; // load cases and combinations share one set of names
    collect_names(cases, "load_cases", model_.load_cases, unreadable_.load_cases);
    collect_names(cases, "combinations", model_.combinations, unreadable_.combinations);
    check_names(cases);
    check_names("paths", model_.moving_loads.paths, unreadable_.paths);
    check_names("influence_lines", model_.moving_loads.influence_lines, unreadable_.influence_lines);
    check_names("trains", model_.moving_loads.trains, unreadable_.trains);
    check_names("moving_envelopes", model_.moving_loads.envelopes, unreadable_.moving_envelopes);
}

void Checker::check_materials()
{
    for (std::size_t i = 0; i < model_.materials.size(); ++i) {
        is_partial_ = !is_readable(MaterialId(i));
        check_material(model_.materials[i], {"materials", i, model_.materials[i].id});
    }
}

void Checker::check_sections()
{
    for (std::size_t i = 0; i < model_.sections.size(); ++i) {
        is_partial_ = !is_readable(SectionId(i));
        check_section(model_.sections[i], {"sections", i, model_.sections[i].id});
    }
}

void Checker::check_section(const Section& section, const Entry& place)
{
    using Field = std::pair<std::string_view, const std::optional<Quantity>&>;
    const std::array<Field, 3> areas{{{"A", section.A}, {"Asy", section.Asy}, {"Asz", section.Asz}}};
    const std::array<Field, 3> moments{{{"Iz", section.Iz}, {"Iy", section.Iy}, {"J", section.J}}};
    for (const auto& [key, value] : areas)
        if (value) require_positive(place, key, *value, dimension::area);
    for (const auto& [key, value] : moments)
        if (value) require_positive(place, key, *value, dimension::second_moment);
    if (section.h) require_positive(place, "h", *section.h, dimension::length);
    if (section.yc) require_not_negative(place, "yc", *section.yc, dimension::length);
    if (section.h && section.yc && *section.yc > *section.h && *section.h > 0.0)
        add(FaultKind::CentroidOutside, place,
            {shown(*section.yc, dimension::length), shown(*section.h, dimension::length)});
    if (section.shape && section.profile) add(FaultKind::ShapeAndProfile, place, {});
    if (section.turned && !section.shape && !section.profile) add(FaultKind::TurnedNumbers, place, {});
    if (section.shape) check_shape(*section.shape, place);
    if (section.profile) check_profile(*section.profile, place);
}

void Checker::check_nodes()
{
    for (std::size_t i = 0; i < model_.nodes.size(); ++i) {
        is_partial_ = !is_readable(NodeId(i));
        check_node(model_.nodes[i], {"nodes", i, model_.nodes[i].id});
    }
}

void Checker::check_node(const Node& node, const Entry& place)
{
    constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
    for (std::size_t i = 0; i < n_coordinates(model_.analysis); ++i) require_within_reach(place, axes[i], node.at[i]);
    if (node.support) check_support(*node.support, place);
    require_distinct(place, node.mass);
    for (const Component& mass : node.mass) {
        if (!dofs(model_.analysis).contains(mass.dof))
            add(FaultKind::MassDofLacking, place,
                {std::string(name(mass.dof)), analysis(), names_of(dofs(model_.analysis))});
        require_not_negative(place, "mass " + std::string(name(mass.dof)), mass.value, mass_dimension(mass.dof));
    }
}

void Checker::check_support(const Support& support, const Entry& place)
{
    const DofSet known = dofs(model_.analysis);
    if (support.kind == SupportKind::Roller && !is_plane(model_.analysis))
        add(FaultKind::RollerNotPlane, place, {analysis()});
    if (support.angle.value() != 0.0 && !is_plane(model_.analysis)) add(FaultKind::AngleNotPlane, place, {analysis()});
    require_finite(place, "angle", support.angle);
    for (const Dof dof : all_dofs)
        if (support.kind == SupportKind::Custom && support.fixed.contains(dof) && !known.contains(dof))
            add(FaultKind::FixedDofLacking, place, {std::string(name(dof)), analysis(), names_of(known)});
    DofSet sprung;
    for (const Spring& spring : support.springs) {
        const std::string dof(name(spring.dof));
        if (!known.contains(spring.dof)) add(FaultKind::SpringDofLacking, place, {dof, analysis(), names_of(known)});
        if (support.blocked(model_.analysis).contains(spring.dof)) add(FaultKind::SpringOnFixedDof, place, {dof});
        if (sprung.contains(spring.dof)) add(FaultKind::RepeatedComponent, place, {dof});
        sprung.insert(spring.dof);
        require_stiffness(place, "spring " + dof, spring.stiffness, spring_dimension(spring.dof));
    }
}

void Checker::check_members()
{
    for (std::size_t i = 0; i < model_.members.size(); ++i) {
        const Member& member = model_.members[i];
        const Entry place{"members", i, member.id};
        for (const NodeId node : member.nodes)
            if (node.index < has_member_.size()) has_member_[node.index] = true;
        is_partial_ = !is_readable(MemberId(i));
        check_references(member, place);
        check_member(member, place);
    }
}

void Checker::check_references(const Member& member, const Entry& place)
{
    for (const NodeId node : member.nodes) require_entry(place, "nodes", node.index, model_.nodes.size());
    if (member.material) require_entry(place, "materials", member.material->index, model_.materials.size());
    if (member.section) require_entry(place, "sections", member.section->index, model_.sections.size());
}

void Checker::check_member(const Member& member, const Entry& place)
{
    if (!member.rigid && !member.material) add(FaultKind::MemberWithoutMaterial, place, {});
    if (!member.rigid && !member.section) add(FaultKind::MemberWithoutSection, place, {});
    if (member.section && !member.rigid) check_section_for(member);
    check_end(member, End::Start, place);
    check_end(member, End::Finish, place);
    if (member.tension_only && member.compression_only) add(FaultKind::TensionAndCompressionOnly, place, {});
    else if (member.tension_only || member.compression_only) add(FaultKind::OneWayMember, place, {});
    if (!member.depths.empty()) check_depths(member, place);
    if (member.foundation) check_foundation(member, place);
    if (is_located(member)) {
        check_length(member, place);
        if (is_truss(model_.analysis))
            for (const End which : {End::Start, End::Finish}) check_truss_offset(member, which, place);
        check_up(member, place);
    }
}

void Checker::check_end(const Member& member, End which, const Entry& place)
{
    const bool is_start = which == End::Start;
    const MemberEnd& end = is_start ? member.start : member.end;
    const std::string at(end_name(is_start));
    const DofSet known = member_dofs(model_.analysis);
    const NodeId node = member.nodes[is_start ? 0 : 1];
    for (const Dof dof : all_dofs)
        if (end.release.contains(dof) && !known.contains(dof))
            add(FaultKind::ReleaseDofLacking, place, {std::string(name(dof)), at, analysis(), names_of(known)});
    DofSet sprung;
    for (const Spring& spring : end.springs) {
        const std::string dof(name(spring.dof));
        if (!known.contains(spring.dof))
            add(FaultKind::EndSpringDofLacking, place, {dof, at, analysis(), names_of(known)});
        if (sprung.contains(spring.dof)) add(FaultKind::RepeatedComponent, place, {dof});
        sprung.insert(spring.dof);
        if (end.release.contains(spring.dof)) add(FaultKind::ReleaseAndSpring, place, {dof, at});
        const bool is_hinged = is_readable(node) && model_[node].hinge && is_rotation(spring.dof);
        if (is_hinged) add(FaultKind::HingeAndSpring, place, {dof, at, model_[node].id});
        if (spring.stiffness.value() == 0.0)
            add(FaultKind::ZeroEndSpring, place,
                {at + " spring " + dof, shown(spring.stiffness, spring_dimension(spring.dof)), dof});
        else require_positive(place, at + " spring " + dof, spring.stiffness, spring_dimension(spring.dof));
    }
    if (!end.offset.empty() && end.offset.size() != n_coordinates(model_.analysis))
        add(FaultKind::OffsetSize, place, {at, std::to_string(end.offset.size()), analysis()});
    for (const Quantity& part : end.offset) require_within_reach(place, at + " offset", part);
}

Checker::Axis Checker::axis(const Member& member) const
{
    const MemberGeometry geometry = geometry_of(model_, member);
    return with_length({.start = point(geometry.start), .end = point(geometry.end)});
}

Checker::Axis Checker::node_axis(const Member& member) const
{
    return with_length(
        {.start = point(position_of(model_, member.nodes[0])), .end = point(position_of(model_, member.nodes[1]))});
}

Checker::Axis Checker::with_length(Axis axis)
{
    axis.length = std::hypot(axis.end[0] - axis.start[0], axis.end[1] - axis.start[1], axis.end[2] - axis.start[2]);
    return axis;
}

void Checker::check_length(const Member& member, const Entry& place)
{
    constexpr double negligible = 1e-9, shortest = 1e-100; // of what is shorter the square may be no number any more
    const Node& first = model_[member.nodes[0]];
    const Node& second = model_[member.nodes[1]];
    const bool has_offset = !member.start.offset.empty() || !member.end.offset.empty();
    const Axis whole = node_axis(member), part = has_offset ? axis(member) : whole;
    if (!std::isfinite(part.length)) return; // the coordinates are faults already
    if (member.nodes[0] == member.nodes[1]) {
        add(FaultKind::SameNodeTwice, place, {first.id});
        is_incomplete_ = true;
    } else if (!has_offset && part.length < shortest) {
        add(FaultKind::ZeroLength, place,
            {shown(Quantity(part.length), dimension::length), first.id, second.id, shown(whole.start)});
    }
    if (!has_offset) return;
    double along = 0.0;
    for (std::size_t i = 0; i < 3; ++i) along += (part.end[i] - part.start[i]) * (whole.end[i] - whole.start[i]);
    if (part.length <= negligible * whole.length || along < 0.0)
        add(FaultKind::OffsetsEatMember, place, {shown(Quantity(whole.length), dimension::length)});
}

void Checker::check_truss_offset(const Member& member, End which, const Entry& place)
{
    constexpr double negligible = 1e-6; // of the length: what rounding in a typed offset leaves
    const bool is_start = which == End::Start;
    const std::vector<Quantity>& offset = (is_start ? member.start : member.end).offset;
    const Axis whole = node_axis(member);
    if (offset.size() != n_coordinates(model_.analysis) || !std::isfinite(whole.length) || whole.length == 0.0) return;
    const Eigen::Vector3d arm = vector_of(offset);
    const Eigen::Vector3d x = (Eigen::Vector3d(whole.end.data()) - Eigen::Vector3d(whole.start.data())) / whole.length;
    const Eigen::Vector3d along = (arm.dot(x) * x).array() + 0.0; // written without a minus zero
    const double across = (arm - along).norm();
    if (!(across > negligible * whole.length)) return;
    add(FaultKind::TrussOffsetAcross, place,
        {std::string(end_name(is_start)), shown(point(arm)), shown(Quantity(across), dimension::length),
         shown(point(along)), is_3d(model_.analysis) ? "frame3d" : "frame2d"});
}

void Checker::check_up(const Member& member, const Entry& place)
{
    if (member.up.empty()) return;
    if (!is_3d(model_.analysis)) return add(FaultKind::UpNot3d, place, {analysis()});
    if (member.up.size() != 3) return add(FaultKind::UpSize, place, {std::to_string(member.up.size())});
    Point up{member.up[0], member.up[1], member.up[2]};
    for (const double part : up)
        if (!require_finite(place, "up", part)) return;
    const double size = std::max({std::abs(up[0]), std::abs(up[1]), std::abs(up[2])});
    if (size == 0.0) return add(FaultKind::UpZero, place, {});
    const Axis along = axis(member);
    if (along.length == 0.0) return;
    Point x{};
    for (std::size_t i = 0; i < 3; ++i) {
        x[i] = (along.end[i] - along.start[i]) / along.length;
        up[i] /= size;
    }
    const double square = std::hypot(x[1] * up[2] - x[2] * up[1], x[2] * up[0] - x[0] * up[2],
                                     x[0] * up[1] - x[1] * up[0]);
    constexpr double smallest_sine = 1e-6;
    if (square < smallest_sine) add(FaultKind::UpAlongMember, place, {});
}

void Checker::check_section_for(const Member& member)
{
    const SectionId id = *member.section;
    if (!is_readable(id)) return;
    const Section& section = model_[id];
    if (section.shape || section.profile) return;
    for (const auto& [key, value] : needs(model_.analysis, member)) {
        if (section.*value || !said_.insert({id.index, key}).second) continue;
        add(FaultKind::MissingProperty, {"sections", id.index, section.id}, {std::string(key), analysis(), member.id});
    }
}

void Checker::check_use()
{
    std::vector<bool> used_materials(model_.materials.size()), used_sections(model_.sections.size());
    for (const Member& member : model_.members) {
        if (member.material && member.material->index < used_materials.size())
            used_materials[member.material->index] = true;
        if (member.section && member.section->index < used_sections.size()) used_sections[member.section->index] = true;
    }
    const auto uses_members = !model_.members.empty();
    for (std::size_t i = 0; i < used_materials.size() && !has_repeated_id_; ++i)
        if (!used_materials[i]) add(FaultKind::UnusedMaterial, {"materials", i, model_.materials[i].id}, {});
    for (std::size_t i = 0; i < used_sections.size() && !has_repeated_id_; ++i)
        if (!used_sections[i]) add(FaultKind::UnusedSection, {"sections", i, model_.sections[i].id}, {});
    for (std::size_t i = 0; uses_members && i < has_member_.size() && !has_repeated_id_; ++i)
        if (!has_member_[i]) add(FaultKind::NodeWithoutMembers, {"nodes", i, model_.nodes[i].id}, {});
    if (!uses_members) faults_.push_back({FaultKind::NoMembers, {}});
}

} // namespace femoop
