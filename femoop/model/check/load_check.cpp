#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string_view>
#include <utility>

#include "femoop/load/place_along.h"
#include "femoop/model/check/checker.h"
#include "femoop/model/quantity/number_text.h"

namespace femoop {

namespace {

constexpr std::size_t nowhere = std::numeric_limits<std::uint32_t>::max();
constexpr double end_tolerance = 1e-9; // of the member's length: so far beyond an end still counts as the end

std::string force(Dof dof) { return std::string(force_name(dof)); }
std::string line_load(Dof dof)
{
    std::string text(force_name(dof));
    if (!is_rotation(dof)) text.front() = 'q';
    return text;
}

bool is_loaded(const std::vector<Component>& components)
{
    return std::any_of(components.begin(), components.end(),
                       [](const Component& part) { return part.value.value() != 0.0; });
}

/// Of each component of a distributed load the larger of its two values.
std::vector<Component> largest_parts(const DistributedLoad& load)
{
    std::vector<Component> parts;
    for (const DistributedLoad::Value& value : load.values) {
        const bool grows = value.end && std::abs(*value.end) > std::abs(value.start);
        parts.push_back({value.dof, grows ? *value.end : value.start});
    }
    return parts;
}

} // namespace

void Checker::check_load_cases()
{
    for (std::size_t i = 0; i < model_.load_cases.size(); ++i) {
        const LoadCase& load_case = model_.load_cases[i];
        const Entry place{"load_cases", i, load_case.id};
        const std::string path = Entry{"load_cases", i, {}}.text();
        const std::string node_path = path + ".nodes", settlement_path = path + ".settlements",
                          member_path = path + ".members";
        check_self_weight(load_case, place);
        const auto check_each = [&](const auto& loads, std::string_view list, const auto& unreadable) {
            for (std::size_t j = 0; j < loads.size(); ++j) {
                is_partial_ = flag(unreadable, i, j);
                check_load(loads[j], {list, j, {}});
            }
            is_partial_ = false;
        };
        check_each(load_case.nodes, node_path, unreadable_.node_loads);
        check_each(load_case.settlements, settlement_path, unreadable_.settlements);
        check_each(load_case.members, member_path, unreadable_.member_loads);
    }
}

void Checker::check_self_weight(const LoadCase& load_case, const Entry& place)
{
    if (!require_finite(place, "self_weight", load_case.self_weight) || load_case.self_weight == 0.0) return;
    std::vector<bool> said_material(model_.materials.size()), said_section(model_.sections.size());
    for (std::size_t i = 0; i < model_.members.size(); ++i) {
        const Member& member = model_.members[i];
        if (member.rigid || !is_readable(MemberId(i))) continue;
        const bool has_material = member.material && is_readable(*member.material);
        if (has_material && !model_[*member.material].density && !said_material[member.material->index]) {
            said_material[member.material->index] = true;
            add(FaultKind::MissingDensity, place, {model_[*member.material].id, member.id});
        }
        if (!member.section || !is_readable(*member.section)) continue;
        const Section& section = model_[*member.section];
        const bool has_area = section.A || section.shape || section.profile;
        if (has_area || model_.analysis != AnalysisKind::Grillage || said_section[member.section->index]) continue;
        said_section[member.section->index] = true;
        add(FaultKind::MissingAreaForWeight, place, {section.id, member.id});
    }
}

void Checker::check_load_dof(Dof dof, LoadAxes axes, std::string_view component, const Entry& place)
{
    const DofSet known = axes == LoadAxes::Local ? member_dofs(model_.analysis) : dofs(model_.analysis);
    if (!known.contains(dof))
        add(FaultKind::LoadDofLacking, place,
            {std::string(component), std::string(name(dof)), analysis(), names_of(known)});
}

void Checker::check_load(const NodeLoad& load, const Entry& place)
{
    const bool has_node = require_entry(place, "nodes", load.node.index, model_.nodes.size());
    is_partial_ = is_partial_ || !has_node;
    require_distinct(place, load.components);
    if (load.components.empty()) add(FaultKind::EmptyLoad, place, {});
    for (const Component& part : load.components) {
        check_load_dof(part.dof, LoadAxes::Global, force_name(part.dof), place);
        require_finite(place, force_name(part.dof), part.value);
    }
    const bool is_lonely = has_node && !has_member_[load.node.index] && !is_incomplete_;
    if (is_lonely && is_loaded(load.components))
        add(FaultKind::LoadedNodeWithoutMembers, place, {model_[load.node].id});
}

void Checker::check_load(const Settlement& settlement, const Entry& place)
{
    const bool has_node = require_entry(place, "nodes", settlement.node.index, model_.nodes.size());
    is_partial_ = is_partial_ || !has_node;
    require_distinct(place, settlement.components);
    if (settlement.components.empty()) add(FaultKind::EmptyLoad, place, {});
    const Node unknown;
    const Node& node = has_node ? model_[settlement.node] : unknown;
    const DofSet known = dofs(model_.analysis);
    DofSet held = node.support ? node.support->blocked(model_.analysis) : DofSet{};
    if (node.support)
        for (const Spring& spring : node.support->springs) held.insert(spring.dof);
    for (const Component& part : settlement.components) {
        const std::string dof(name(part.dof));
        require_finite(place, dof, part.value);
        if (!known.contains(part.dof)) add(FaultKind::LoadDofLacking, place, {dof, dof, analysis(), names_of(known)});
        else if (!held.contains(part.dof) && is_readable(settlement.node))
            add(FaultKind::SettlementOfFreeDof, place, {dof, node.id});
    }
}

void Checker::check_load(const MemberLoad& load, const Entry& place)
{
    if (!require_entry(place, "members", load.member.index, model_.members.size())) is_partial_ = true;
    static const Member unknown{
        .nodes = {NodeId(nowhere), NodeId(nowhere)}, .material = MaterialId(nowhere), .section = SectionId(nowhere)};
    const Member& member = is_readable(load.member) ? model_[load.member] : unknown;
    std::visit([&](const auto& kind) { check_span(kind, member, place); }, load.load);
}

/// A bar carries span loads across its axis as a simple beam, but nothing holds it against turning about that axis.
void Checker::check_torque(const Member& member, LoadAxes axes, const std::vector<Component>& parts, const Entry& place)
{
    constexpr double negligible = 1e-9; // of the moment: a bar that is loaded square to its axis in other numbers
    if (!member.bar || is_truss(model_.analysis) || !is_located(member)) return;
    const Axis line = axis(member);
    double torque = 0.0, moment = 0.0;
    for (const Component& part : parts) {
        if (!is_rotation(part.dof)) continue;
        const std::size_t i = index(part.dof) - 3;
        const double share = axes == LoadAxes::Local ? (i == 0 ? 1.0 : 0.0)
                                                     : (line.end[i] - line.start[i]) / line.length;
        torque += share * part.value;
        moment = std::max(moment, std::abs(part.value.value()));
    }
    if (std::abs(torque) > negligible * moment) add(FaultKind::TorqueOnBar, place, {member.id});
}

std::optional<double> Checker::check_position(const Position& position, std::string_view key, const Member& member,
                                              const Entry& place)
{
    if (!is_located(member)) return std::nullopt;
    const double length = axis(member).length;
    const Percent* const percent = std::get_if<Percent>(&position);
    const double x = written_place(position, length);
    const bool has_length = std::isfinite(length) && length > 0.0; // else the member is a fault
    if (!require_finite(place, key, x) || !has_length) return std::nullopt;
    const std::string found = percent ? number_text(percent->value) + "%"
                                      : shown(std::get<Quantity>(position), dimension::length);
    const std::vector<std::string> details{std::string(key), found, member.id,
                                           shown(Quantity(length), dimension::length)};
    const double slack = end_tolerance * length;
    if (x < -slack) add(FaultKind::PositionBeforeStart, place, details);
    if (x > length + slack) add(FaultKind::PositionBeyondEnd, place, details);
    return x;
}

void Checker::check_span(const DistributedLoad& load, const Member& member, const Entry& place)
{
    if (load.values.empty()) add(FaultKind::EmptyLoad, place, {});
    DofSet seen;
    for (const DistributedLoad::Value& value : load.values) {
        const std::string key = line_load(value.dof);
        if (seen.contains(value.dof)) add(FaultKind::RepeatedComponent, place, {key});
        seen.insert(value.dof);
        check_load_dof(value.dof, load.axes, key, place);
        require_finite(place, key, value.start);
        if (value.end) require_finite(place, key, *value.end);
        if (load.projected && is_rotation(value.dof)) add(FaultKind::ProjectedMoment, place, {key});
    }
    if (member.bar) check_torque(member, load.axes, largest_parts(load), place);
    if (load.projected && load.axes == LoadAxes::Local) add(FaultKind::ProjectedLocalLoad, place, {});
    if ((!load.from && !load.to) || !is_located(member)) return;
    const auto n_before = faults_.size();
    const auto from = load.from ? check_position(*load.from, "from", member, place) : 0.0;
    const auto to = load.to ? check_position(*load.to, "to", member, place) : axis(member).length;
    if (faults_.size() == n_before && from && to && *from >= *to)
        add(FaultKind::LoadEndsBeforeStart, place,
            {shown(Quantity(*from), dimension::length), shown(Quantity(*to), dimension::length)});
}

void Checker::check_span(const PointLoad& load, const Member& member, const Entry& place)
{
    if (load.components.empty()) add(FaultKind::EmptyLoad, place, {});
    require_distinct(place, load.components);
    check_position(load.at, "at", member, place);
    check_torque(member, load.axes, load.components, place);
    for (const Component& part : load.components) {
        check_load_dof(part.dof, load.axes, force_name(part.dof), place);
        require_finite(place, force_name(part.dof), part.value);
    }
}

void Checker::check_span(const EndLoads& load, const Member& member, const Entry& place)
{
    if (load.start.empty() && load.end.empty()) add(FaultKind::EmptyLoad, place, {});
    const auto check_parts = [&](const std::vector<Component>& parts, const std::string& end) {
        require_distinct(place, parts);
        check_torque(member, load.axes, parts, place);
        for (const Component& part : parts) {
            check_load_dof(part.dof, load.axes, end + force(part.dof), place);
            require_finite(place, end + force(part.dof), part.value);
        }
    };
    check_parts(load.start, "start_");
    check_parts(load.end, "end_");
}

void Checker::check_span(const TemperatureLoad& load, const Member& member, const Entry& place)
{
    const bool has_top = require_finite(place, "top", load.top),
               has_bottom = require_finite(place, "bottom", load.bottom);
    if (!has_top || !has_bottom || (load.top.value() == 0.0 && load.bottom.value() == 0.0)) return;
    if (!member.material || !member.section) return add(FaultKind::TemperatureOfRigid, place, {member.id});
    if (is_readable(*member.material) && !model_[*member.material].alpha)
        add(FaultKind::MissingExpansion, place, {model_[*member.material].id, member.id});
    if (!is_readable(*member.section)) return;
    const Section& section = model_[*member.section];
    const bool has_depth = section.h || section.shape || section.profile;
    if (load.top.value() != load.bottom.value() && !has_depth)
        add(FaultKind::MissingDepth, place, {section.id, member.id});
}

void Checker::check_span(const Misfit& load, const Member& /*member*/, const Entry& place)
{
    require_finite(place, "elongation", load.elongation);
    if (model_.analysis == AnalysisKind::Grillage) add(FaultKind::MisfitOfGrillage, place, {});
}

} // namespace femoop
