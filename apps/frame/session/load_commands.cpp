#include "apps/frame/session/load_commands.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "apps/frame/document/command.h"
#include "apps/frame/document/loading.h"
#include "apps/frame/tools/load_tool.h"
#include "apps/frame/tools/tool_loads.h"
#include "femoop/model/quantity/quantity_parser.h"

namespace frame {

using namespace femoop;
using ui::Message;
using ui::Reason;
using ui::translatable;

std::optional<Message> why_shown_case_takes_no_load(const Session& session)
{
    if (session.view.is_envelope) return translatable("the envelope is shown; choose a load case first");
    if (session.view.load_case.index < session.model().load_cases.size() || session.model().n_cases() == 0)
        return std::nullopt;
    return translatable("a combination has no loads of its own; choose a load case first");
}

namespace {

/// The nodes and members that are meant by the selection: themselves, and those whose loads are selected.
struct Targets {
    std::vector<NodeId> nodes;
    std::vector<MemberId> members;

    explicit Targets(const Session& session)
    {
        for (const Part& part : session.selection.parts())
            take(is_load(part) ? bearer_of(session.model(), part) : part);
    }
    bool is_empty() const { return nodes.empty() && members.empty(); }

private:
    void take(const Part& part)
    {
        const auto add = [](auto& list, auto id) {
            if (std::ranges::find(list, id) == list.end()) list.push_back(id);
        };
        if (const auto* const node = std::get_if<NodeId>(&part)) add(nodes, *node);
        if (const auto* const member = std::get_if<MemberId>(&part)) add(members, *member);
    }
};

/// A quantity that is begun with, as a person would write it.
Quantity typed(std::string_view text, Dimension dimension, const Units& units)
{
    return {std::get<double>(parse_quantity(text, dimension, units)), std::string(text)};
}

/// The directions of a model of this kind in the order in which a hand means them: down first.
std::vector<Dof> directions(AnalysisKind kind)
{
    const bool is_upright = kind == AnalysisKind::Grillage || is_3d(kind);
    std::vector<Dof> order{is_upright ? Dof::uz : Dof::uy};
    for (const Dof dof : all_dofs)
        if (dofs(kind).contains(dof) && dof != order.front()) order.push_back(dof);
    return order;
}

// ---- why not ----

Reason needs_members(const Workspace& workspace)
{
    if (const Reason reason = why_shown_case_takes_no_load(workspace.session)) return reason;
    if (!Targets(workspace.session).members.empty()) return std::nullopt;
    return translatable("select members first");
}

// A direction in which the support is held or sprung, and nothing is imposed in this case yet.
std::optional<Dof> dof_to_settle(const Session& session, NodeId node)
{
    const Model& model = session.model();
    const std::optional<Support>& support = model[node].support;
    if (!support) return std::nullopt;
    DofSet there;
    if (session.view.load_case.index < model.load_cases.size())
        for (const Settlement& settlement : model.load_cases[session.view.load_case.index].settlements)
            for (const Component& component : settlement.components)
                if (settlement.node == node) there.insert(component.dof);
    for (const Dof dof : directions(model.analysis)) {
        const bool is_sprung = std::ranges::find(support->springs, dof, &Spring::dof) != support->springs.end();
        if ((is_sprung || support->blocked(model.analysis).contains(dof)) && !there.contains(dof)) return dof;
    }
    return std::nullopt;
}

std::optional<Dof> dof_to_spring(const Model& model, NodeId node)
{
    for (const Dof dof : directions(model.analysis)) {
        const std::optional<Support>& support = model[node].support;
        if (!support || std::ranges::find(support->springs, dof, &Spring::dof) == support->springs.end()) return dof;
    }
    return std::nullopt;
}

Reason why_not_settle(const Workspace& workspace)
{
    if (const Reason reason = why_shown_case_takes_no_load(workspace.session)) return reason;
    const Targets targets(workspace.session);
    if (targets.nodes.empty()) return translatable("select supported nodes first");
    for (const NodeId node : targets.nodes) {
        const Message::Argument name{"node", workspace.session.model()[node].id};
        if (!workspace.session.model()[node].support)
            return Message(translatable("node {node} has no support that could settle"), {name});
        if (!dof_to_settle(workspace.session, node))
            return Message(translatable("node {node} settles in every direction that its support holds already"),
                           {name});
    }
    return std::nullopt;
}

Reason why_not_spring(const Workspace& workspace)
{
    const Targets targets(workspace.session);
    if (targets.nodes.empty()) return translatable("select nodes first");
    for (const NodeId node : targets.nodes)
        if (!dof_to_spring(workspace.session.model(), node))
            return Message(translatable("node {node} has a spring in every direction already"),
                           {{"node", workspace.session.model()[node].id}});
    return std::nullopt;
}

Reason why_not_warm(const Workspace& workspace)
{
    if (const Reason reason = needs_members(workspace)) return reason;
    const Model& model = workspace.session.model();
    for (const MemberId member : Targets(workspace.session).members) {
        const auto material = model[member].material;
        if (material && !model[*material].alpha)
            return Message(translatable("material {material} has no thermal expansion; give it one first"),
                           {{"material", model[*material].id}});
    }
    return std::nullopt;
}

Reason why_not_turn_ends(const Workspace& workspace)
{
    if (is_truss(workspace.session.model().analysis))
        return translatable("the members of a truss have no moments at their ends");
    return needs_members(workspace);
}

// ---- what is done ----

Message about(const Session& session, std::string_view what, std::span<const Part> parts)
{
    if (parts.size() != 1) return what;
    return {"{what}: {part}", {{"what", Message(what)}, {"part", title(session.document(), parts.front())}}};
}

/// Adds one load to each part, and selects what came.
void add_loads(Workspace& workspace, std::string_view what, std::span<const Part> parts,
               const std::function<Part(Document&, LoadCasePlace, const Part&)>& add)
{
    Session& session = workspace.session;
    Selection added;
    const bool is_done = session.change_soundly({about(session, what, parts), [&](Document& document) {
                                                     added.clear();
                                                     const auto place = load_case_for(document, session.view.load_case);
                                                     for (const Part& part : parts)
                                                         added.add(add(document, place, part));
                                                 }});
    if (!is_done) return;
    session.selection = added;
    workspace.topic = Topic::Properties;
}

void add_to_members(Workspace& workspace, std::string_view what, const MemberLoadValue& load)
{
    const std::vector<MemberId> members = Targets(workspace.session).members;
    add_loads(workspace, what, std::vector<Part>(members.begin(), members.end()),
              [&](Document& document, LoadCasePlace place, const Part& part) {
                  return add_member_load(document, place, std::get<MemberId>(part), load);
              });
}

void settle(Workspace& workspace, std::string_view what)
{
    const std::vector<NodeId> nodes = Targets(workspace.session).nodes;
    const Units& units = workspace.session.model().units;
    const Quantity down = typed("-10 mm", dimension::length, units), turn(0.001);
    std::vector<Component> settlements; // told from the document as it was
    for (const NodeId node : nodes) {
        const Dof dof = dof_to_settle(workspace.session, node).value();
        settlements.push_back({dof, is_rotation(dof) ? turn : down});
    }
    add_loads(workspace, what, std::vector<Part>(nodes.begin(), nodes.end()),
              [&](Document& document, LoadCasePlace place, const Part& part) {
                  const auto i = std::ranges::find(nodes, std::get<NodeId>(part)) - nodes.begin();
                  return add_settlement(document, place, std::get<NodeId>(part),
                                        settlements[static_cast<std::size_t>(i)]);
              });
}

void spring(Workspace& workspace, std::string_view what)
{
    Session& session = workspace.session;
    const std::vector<NodeId> nodes = Targets(session).nodes;
    const std::vector<Part> parts(nodes.begin(), nodes.end());
    const Units& units = session.model().units;
    const Quantity along = typed("1000 kN/m", dimension::force_per_length, units),
                   about_axis = typed("1000 kN*m/rad", dimension::moment_per_angle, units);
    const bool is_done = session.change_soundly(
        {about(session, what, parts), [&](Document& document) {
             for (const NodeId node : nodes) {
                 const Dof dof = dof_to_spring(document.model, node).value();
                 set_spring(document, node, {dof, is_rotation(dof) ? about_axis : along});
             }
         }});
    if (!is_done) return;
    session.selection.clear();
    for (const Part& part : parts) session.selection.add(part);
    workspace.topic = Topic::Properties;
}

void add_part_load(Workspace& workspace, std::string_view what)
{
    ToolSettings settings = workspace.tool_controller.settings();
    settings.load = {LoadKind::Uniform, LoadWay::Down};
    const LoadReach middle{.from = Percent{25.0}, .to = Percent{75.0}};
    add_to_members(workspace, what, member_load_of(settings, workspace.session.model().analysis, middle).value());
}

void add_temperature(Workspace& workspace, std::string_view what)
{
    add_to_members(workspace, what, TemperatureLoad{.top = Quantity(20.0), .bottom = Quantity(20.0)});
}

void add_misfit(Workspace& workspace, std::string_view what)
{
    add_to_members(workspace, what, Misfit{typed("1 mm", dimension::length, workspace.session.model().units)});
}

void add_end_moments(Workspace& workspace, std::string_view what)
{
    const Quantity& moment = workspace.tool_controller.settings().moment;
    add_to_members(
        workspace, what,
        EndLoads{.start = {{Dof::rz, Quantity(-moment)}}, .end = {{Dof::rz, moment}}, .axes = LoadAxes::Local});
}

// ---- the loads that the tool has too ----

/// As a structure of this kind has it; null where it has none such.
const ToolLoadEntry* entry_named(std::string_view command, AnalysisKind kind)
{
    const auto found = std::ranges::find(tool_loads(kind), command, &ToolLoadEntry::command);
    return found != tool_loads(kind).end() ? &*found : nullptr;
}

ToolSettings set_to(const Workspace& workspace, const ToolLoad& load)
{
    ToolSettings settings = workspace.tool_controller.settings();
    settings.load = load;
    return settings;
}

Reason why_not_load(const Workspace& workspace, std::string_view command)
{
    if (const Reason reason = why_shown_case_takes_no_load(workspace.session)) return reason;
    const Targets targets(workspace.session);
    const AnalysisKind analysis = workspace.session.model().analysis;
    const ToolLoadEntry* const entry = entry_named(command, analysis);
    const Reason unknown = translatable("a structure of this kind has no such load");
    if (entry == nullptr) return unknown;
    const ToolSettings settings = set_to(workspace, entry->load);
    if (!member_load_of(settings, analysis, {})) return unknown;
    if (targets.members.empty() && !targets.nodes.empty() && !force_of(settings, analysis))
        return translatable("a node bears forces and moments alone; select members");
    return std::nullopt;
}

/// Where the menu was asked for on this member; else wherever it usually lies.
LoadReach reach_on(const Workspace& workspace, MemberId member)
{
    const auto& cut = workspace.menu_cut;
    if (!cut || cut->member != member) return {};
    return {.at = Quantity(cut->x)};
}

void load(Workspace& workspace, std::string_view command)
{
    const Targets targets(workspace.session);
    const AnalysisKind analysis = workspace.session.model().analysis;
    const ToolLoadEntry& entry = *entry_named(command, analysis);
    const ToolSettings settings = set_to(workspace, entry.load);
    if (targets.is_empty()) {
        workspace.tool_controller.settings().load = entry.load;
        return workspace.tool_controller.select(ToolKind::Load);
    }
    const auto force = force_of(settings, analysis);
    std::vector<Part> parts(targets.members.begin(), targets.members.end());
    if (force) parts.insert(parts.end(), targets.nodes.begin(), targets.nodes.end());
    add_loads(workspace, entry.label, parts, [&](Document& document, LoadCasePlace place, const Part& part) {
        if (const auto* const node = std::get_if<NodeId>(&part)) return add_node_load(document, place, *node, *force);
        const auto member = std::get<MemberId>(part);
        return add_member_load(document, place, member,
                               member_load_of(settings, analysis, reach_on(workspace, member)).value());
    });
}

// ---- the others ----

struct OtherLoad {
    std::string_view id, label;
    void (*run)(Workspace&, std::string_view);
    Reason (*why_not)(const Workspace&);
};
constexpr std::array other_loads{
    OtherLoad{"load.part", translatable("Add a load on a part of the member"), add_part_load, needs_members},
    OtherLoad{"load.end_moments", translatable("Add end moments"), add_end_moments, why_not_turn_ends},
    OtherLoad{"load.temperature", translatable("Add a temperature"), add_temperature, why_not_warm},
    OtherLoad{"load.misfit", translatable("Add a misfit"), add_misfit, needs_members},
    OtherLoad{"load.settlement", translatable("Add a settlement"), settle, why_not_settle},
    OtherLoad{"load.spring", translatable("Add a spring"), spring, why_not_spring},
};

// By the tool's table of plane structures, and beyond them, which no menu has, of those in space.
void add_tool_loads(CommandTable& table)
{
    const auto add = [&](std::string_view menu, const ToolLoadEntry& entry) {
        if (table.find(entry.command) != nullptr) return;
        const auto run = [command = entry.command](Workspace& workspace) { load(workspace, command); };
        const auto why_not = [command = entry.command](const Workspace& workspace) {
            return why_not_load(workspace, command);
        };
        Menu(table, menu).step({entry.command, entry.label}, run, why_not).live_label =
            [plain = entry](const Workspace& workspace) -> Message {
            const auto* const here = entry_named(plain.command, workspace.session.model().analysis);
            return here != nullptr ? here->label : plain.label;
        };
    };
    for (const ToolLoadEntry& entry : tool_loads(AnalysisKind::Frame2d)) add(translatable("Loads"), entry);
    for (const ToolLoadEntry& entry : tool_loads(AnalysisKind::Frame3d)) add({}, entry);
}

} // namespace

void add_load_commands(CommandTable& table)
{
    add_tool_loads(table);
    Menu menu(table, translatable("Loads"));
    for (const OtherLoad& entry : other_loads)
        menu.step(
            {entry.id, entry.label}, [entry](Workspace& workspace) { entry.run(workspace, entry.label); },
            entry.why_not);
}

std::vector<std::string_view> loads_for_nodes(AnalysisKind kind)
{
    std::vector<std::string_view> commands;
    for (const ToolLoadEntry& entry : tool_loads(kind))
        if (force_of({.load = entry.load}, kind)) commands.push_back(entry.command);
    commands.insert(commands.end(), {"load.settlement", "load.spring"});
    return commands;
}

std::vector<std::string_view> loads_for_members(AnalysisKind kind)
{
    std::vector<std::string_view> lines, forces;
    for (const ToolLoadEntry& entry : tool_loads(kind)) {
        if (!member_load_of({.load = entry.load}, kind, {})) continue;
        const bool is_force = entry.load.kind == LoadKind::Force || entry.load.kind == LoadKind::Moment;
        (is_force ? forces : lines).push_back(entry.command);
    }
    lines.emplace_back("load.part");
    lines.insert(lines.end(), forces.begin(), forces.end());
    lines.insert(lines.end(), {"load.end_moments", "load.temperature", "load.misfit"});
    return lines;
}

bool is_load(const Part& part)
{
    return std::holds_alternative<NodeLoadPlace>(part) || std::holds_alternative<SettlementPlace>(part) ||
           std::holds_alternative<MemberLoadPlace>(part);
}

Part bearer_of(const Model& model, const Part& load)
{
    if (const auto* const place = std::get_if<NodeLoadPlace>(&load))
        return model.load_cases.at(place->load_case).nodes.at(place->load).node;
    if (const auto* const place = std::get_if<SettlementPlace>(&load))
        return model.load_cases.at(place->load_case).settlements.at(place->settlement).node;
    const auto& place = std::get<MemberLoadPlace>(load);
    return model.load_cases.at(place.load_case).members.at(place.load).member;
}

} // namespace frame
