#include "apps/frame/session/table_commands.h"

#include <array>

namespace frame {

using ui::Key;
using ui::translatable;

namespace {

constexpr std::string_view tables_menu = translatable("Tables");

struct TableEntry {
    TableKind kind;
    std::string_view id;
};
constexpr std::array table_entries{
    TableEntry{TableKind::Nodes, "view.table.nodes"},
    TableEntry{TableKind::Members, "view.table.members"},
    TableEntry{TableKind::Joints, "view.table.joints"},
    TableEntry{TableKind::Materials, "view.table.materials"},
    TableEntry{TableKind::Sections, "view.table.sections"},
    TableEntry{TableKind::LoadCases, "view.table.load_cases"},
    TableEntry{TableKind::Combinations, "view.table.combinations"},
    TableEntry{TableKind::NodeLoads, "view.table.node_loads"},
    TableEntry{TableKind::DistributedLoads, "view.table.distributed_loads"},
    TableEntry{TableKind::PointLoads, "view.table.point_loads"},
    TableEntry{TableKind::EndLoads, "view.table.end_loads"},
    TableEntry{TableKind::Temperatures, "view.table.temperatures"},
    TableEntry{TableKind::Misfits, "view.table.misfits"},
    TableEntry{TableKind::Settlements, "view.table.settlements"},
    TableEntry{TableKind::Displacements, "view.table.displacements"},
    TableEntry{TableKind::Reactions, "view.table.reactions"},
    TableEntry{TableKind::MemberEnds, "view.table.member_ends"},
    TableEntry{TableKind::Extremes, "view.table.extremes"},
    TableEntry{TableKind::Envelope, "view.table.envelope"},
    TableEntry{TableKind::ReactionEnvelope, "view.table.reaction_envelope"},
};

bool shows(const Desk& desk, TableKind kind)
{
    return desk.bottom.shows(BottomContent::Table) && desk.bottom.table == kind;
}

bool shows_member(const Desk& desk) { return desk.bottom.shows(BottomContent::Member); }

// From the solver to the tables it is one key.
void open_or_close(BottomView& bottom)
{
    const bool is_left = bottom.shows(BottomContent::Solver);
    bottom.is_open = is_left || !bottom.is_open;
    if (bottom.content == BottomContent::Solver) bottom.content = BottomContent::Table;
}

} // namespace

std::string_view command_id(TableKind kind)
{
    for (const TableEntry& entry : table_entries) {
        if (entry.kind == kind) return entry.id;
    }
    return "";
}

void add_table_commands(CommandTable& table)
{
    table.add({.id = "view.tables",
               .menu = tables_menu,
               .label = translatable("Panel of tables"),
               .shortcuts = {{Key::F4, {}}},
               .run = [](Desk& desk) { open_or_close(desk.bottom); },
               .is_on = [](const Desk& desk) { return desk.bottom.is_open; }});
    for (const TableEntry& entry : table_entries) {
        table.add({.id = entry.id,
                   .menu = tables_menu,
                   .label = title(entry.kind),
                   .run =
                       [kind = entry.kind](Desk& desk) {
                           desk.bottom = {!shows(desk, kind), kind};
                       },
                   .is_on = [kind = entry.kind](const Desk& desk) { return shows(desk, kind); }});
    }
    table.add({.id = "view.member_results",
               .menu = tables_menu,
               .label = translatable("Diagrams of the member"),
               .shortcuts = {{Key::F4, ui::shift}},
               .run =
                   [](Desk& desk) {
                       desk.bottom = {!shows_member(desk), desk.bottom.table, BottomContent::Member};
                   },
               .why_not = [](const Desk& desk) -> std::optional<ui::Phrase> {
                   if (shows_member(desk) || desk.session.solution().results) return std::nullopt;
                   return translatable("There are no results: see the problems.");
               },
               .is_on = shows_member});
    table.add({.id = "file.export_table",
               .menu = tables_menu,
               .label = translatable("Export the table as CSV…"),
               .run = [](Desk& desk) { desk.requests.push_back(Request::ExportTable); },
               .why_not = [](const Desk& desk) -> std::optional<ui::Phrase> {
                   if (desk.bottom.shows(BottomContent::Table)) return std::nullopt;
                   return translatable("no table is shown; choose one");
               }});
}

} // namespace frame
