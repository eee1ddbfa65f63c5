#include "apps/frame/session/fault_target.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "apps/frame/document/fault/field.h"
#include "apps/frame/document/fault/place.h"
#include "apps/frame/tables/columns.h"

namespace frame {

using femoop::CaseId;
using femoop::Fault;
using femoop::FaultKind;
using femoop::Model;

namespace {

template <class Id, class Entries> std::optional<Part> entry_named(const Entries& list, const std::string& name)
{
    const auto found = std::ranges::find_if(list, [&](const auto& entry) { return entry.id == name; });
    if (found == list.end()) return std::nullopt;
    return Id(static_cast<std::size_t>(found - list.begin()));
}

/// The part whose field is to be filled in.
std::optional<Part> mended_part(const Model& model, const Fault& fault)
{
    const Remedy remedy = remedy_of(fault);
    if (remedy.list == "materials" && !remedy.id.empty())
        return entry_named<femoop::MaterialId>(model.materials, remedy.id);
    if (remedy.list == "sections" && !remedy.id.empty())
        return entry_named<femoop::SectionId>(model.sections, remedy.id);
    const std::optional<FaultPlace> place = place_of(fault);
    return place ? part_at(*place, model) : std::nullopt;
}

/// The node or member that a load acts on; another part itself.
Part marked_part_of(const Model& model, const Part& part)
{
    if (const auto* const p = std::get_if<NodeLoadPlace>(&part))
        return model.load_cases[p->load_case].nodes[p->load].node;
    if (const auto* const p = std::get_if<SettlementPlace>(&part))
        return model.load_cases[p->load_case].settlements[p->settlement].node;
    if (const auto* const p = std::get_if<MemberLoadPlace>(&part))
        return model.load_cases[p->load_case].members[p->load].member;
    return part;
}

/// What the fault is about in the picture: of a load that lacks something elsewhere, what it acts on.
std::optional<Part> part_about(const Model& model, const Fault& fault)
{
    const std::optional<Part> mended = mended_part(model, fault);
    const std::optional<FaultPlace> place = place_of(fault);
    if (!place || !place->is_load()) return mended;
    const std::optional<Part> load = part_at(*place, model);
    return load && load != mended ? std::optional(marked_part_of(model, *load)) : mended;
}

std::vector<std::string> names_in(const Fault& fault)
{
    std::vector<std::string> names;
    std::istringstream list(fault.arguments.empty() ? "" : fault.arguments.front());
    for (std::string name; std::getline(list, name, '\x1f');) names.push_back(name); // as femoop::listed parts them
    return names;
}

bool names_members(FaultKind kind)
{
    return kind == FaultKind::MechanismMemberSwings || kind == FaultKind::MechanismMemberFlies ||
           kind == FaultKind::ConstraintConflict || kind == FaultKind::CrossRigidMember ||
           kind == FaultKind::CrossSkewOffset || kind == FaultKind::CrossAxialSpring ||
           kind == FaultKind::CrossHeldElongation || kind == FaultKind::CrossHeldSettlement;
}

/// Of a fault that the analysis found: the nodes or members that it names.
Selection parts_named(const Model& model, const Fault& fault)
{
    Selection selection;
    for (const std::string& name : names_in(fault)) {
        const auto part = names_members(fault.kind) ? entry_named<femoop::MemberId>(model.members, name)
                                                    : entry_named<femoop::NodeId>(model.nodes, name);
        if (part) selection.add(*part);
    }
    return selection;
}

std::optional<CaseId> case_about(const Session& session, const Fault& fault)
{
    if (const auto id = case_of(fault, session.model())) return id;
    for (const BlankCase& one : session.solution().blank)
        if (std::ranges::find(one.faults, fault) != one.faults.end()) return one.id;
    return std::nullopt;
}

void bring_case_forth(Session& session, CaseId id)
{
    session.view.load_case = id;
    session.view.is_envelope = false;
}

std::optional<std::size_t> column_of(const std::vector<Column>& columns, const std::optional<Field>& field)
{
    if (!field) return std::nullopt;
    const ui::Catalogue english;
    const std::string wanted = english(field->heading);
    const auto found = std::ranges::find_if(columns, [&](const Column& c) { return english(c.heading) == wanted; });
    return found != columns.end() ? std::optional(static_cast<std::size_t>(found - columns.begin())) : std::nullopt;
}

/// The table that has the field of the part; without such a field the one that lists the part.
std::optional<BottomView> table_with(const Model& model, const Part& part, const std::optional<Field>& field)
{
    std::optional<BottomView> found;
    for (const TableKind kind : all_table_kinds) {
        if (is_result(kind)) continue;
        const std::vector<Part> listed = parts_of(model, kind);
        if (std::ranges::find(listed, part) == listed.end()) continue;
        const std::optional<std::size_t> column = column_of(columns(model, kind), field);
        const BottomView table{true, kind, BottomContent::Table, WantedCell{part, column.value_or(0)}};
        if (column) return table;
        if (!found) found = table;
    }
    return found;
}

} // namespace

void go_to(Workspace& workspace, const Fault& fault)
{
    Session& session = workspace.session;
    if (const auto id = case_about(session, fault)) bring_case_forth(session, *id);
    const std::optional<Part> about = part_about(session.model(), fault);
    const Selection named = about ? Selection(*about) : parts_named(session.model(), fault);
    if (!named.is_empty()) session.selection = named;
    const std::optional<Part> mended = mended_part(session.model(), fault);
    if (!mended) return;
    if (auto table = table_with(session.model(), *mended, field_of(remedy_of(fault))))
        workspace.bottom = std::move(*table);
}

} // namespace frame
