#include "apps/frame/session/table_commands.h"

#include <algorithm>
#include <array>

namespace frame {

using ui::Key;
using ui::translatable;

namespace {

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

constexpr std::string_view prefix = "view.table.", kept_word = "table ";

bool shows_member(const Workspace& workspace) { return workspace.bottom.shows(BottomContent::Member); }

// One that is shown already is chosen to be typed into.
void show_table(Workspace& workspace, TableKind kind)
{
    workspace.bottom = {.is_open = true, .table = kind, .asks_for_keyboard = true};
}

// From the solver or a derivation to the tables it is one key.
void open_or_close(Workspace& workspace)
{
    BottomView& bottom = workspace.bottom;
    const bool is_left = bottom.is_open && !is_table_or_member(bottom.content);
    bottom.is_open = is_left || !bottom.is_open;
    if (!is_table_or_member(bottom.content)) bottom.content = BottomContent::Table;
}

void show_member(Workspace& workspace, bool is_on)
{
    workspace.bottom = {is_on, workspace.bottom.table, BottomContent::Member};
}

ui::Reason why_no_member_results(const Workspace& workspace)
{
    if (shows_member(workspace) || workspace.session.solution().results) return std::nullopt;
    return translatable("There are no results: see the problems.");
}

ui::Reason why_not_export(const Workspace& workspace)
{
    if (workspace.bottom.shows(BottomContent::Table)) return std::nullopt;
    return translatable("no table is shown; choose one");
}

} // namespace

std::string_view command_id(TableKind kind)
{
    for (const TableEntry& entry : table_entries) {
        if (entry.kind == kind) return entry.id;
    }
    return "";
}

std::string kept_words(const BottomView& bottom)
{
    if (!bottom.shows(BottomContent::Table)) return {};
    return std::string(kept_word) += command_id(bottom.table).substr(prefix.size());
}

void take_up(BottomView& bottom, std::string_view words)
{
    const auto is_named = [&](const TableEntry& entry) {
        return words.ends_with(std::string(kept_word) += entry.id.substr(prefix.size()));
    };
    const auto named = std::find_if(table_entries.begin(), table_entries.end(), is_named);
    if (named != table_entries.end()) bottom = {.is_open = true, .table = named->kind};
}

void add_table_commands(CommandTable& table)
{
    const auto shown = [](const Workspace& workspace) -> std::optional<TableKind> {
        return workspace.bottom.shows(BottomContent::Table) ? std::optional(workspace.bottom.table) : std::nullopt;
    };
    Menu menu(table, translatable("Tables"));
    menu.step({"view.tables", translatable("Panel of tables"), {{Key::F4, {}}}}, open_or_close).is_on =
        [](const Workspace& workspace) { return workspace.bottom.is_open; };
    for (const TableEntry& entry : table_entries)
        menu.choice(ui::Choice<TableKind>{entry.kind, entry.id, title(entry.kind)}, shown, show_table);
    menu.toggle({"view.member_results", translatable("Diagrams of the member"), {{Key::F4, ui::shift}}}, shows_member,
                show_member, why_no_member_results);
    menu.step(
        {"file.export_table", translatable("Export the table as CSV…")},
        [](Workspace& workspace) { workspace.requests.push_back(Request::ExportTable); }, why_not_export);
}

} // namespace frame
