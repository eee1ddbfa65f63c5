#include "apps/plane/window/tables_panel.h"

#include <imgui.h>

#include <algorithm>
#include <optional>

#include "apps/plane/document/load_cases.h"
#include "apps/plane/document/regions.h"
#include "apps/plane/session/part_commands.h"
#include "apps/plane/view/plate_scene.h"
#include "apps/plane/view/reaction_marks.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/panel.h"

namespace plane {

using ui::translatable;

namespace {

/// An entry: its name, words that are shown alone, and numbers that are typed.
struct TableRow {
    ui::Message whose;
    std::string name;
    std::optional<Part> part{}; ///< that a click on the name selects
    std::vector<std::string> words{};
    std::vector<Number> numbers{};
    std::optional<std::size_t> mode{}; ///< that a click on the name shows
};

struct PartTable {
    std::vector<std::string> words; ///< headings of what is shown alone
    std::vector<std::string> ids;   ///< of the numbers, in their columns
    std::vector<TableRow> rows;
};

std::string support_word(const std::optional<femoop::plane::PlaneSupport>& support, const ui::Catalogue& tr)
{
    using enum femoop::plane::PlaneSupportKind;
    if (!support) return "";
    switch (support->kind) {
    case Fixed:
    case Pin: return tr("Fixed");
    case Roller: return tr("Roller");
    case Symmetry: return tr("Symmetry");
    case Custom: break;
    }
    return tr("Own axes and springs");
}

PartTable table_of_points(const Session& session)
{
    const ui::Catalogue& tr = session.tr();
    PartTable table{{tr("Support")}, {"x", "y", "fx", "fy", "size"}, {}};
    for (std::size_t i = 0; i < session.model().points.size(); ++i) {
        const auto& point = session.model().points[i];
        const Part part = NodeId(i);
        table.rows.push_back(
            {title(session, part), point.id, part, {support_word(point.support, tr)}, numbers_of(session, part)});
    }
    return table;
}

PartTable table_of_curves(const Session& session)
{
    const ui::Catalogue& tr = session.tr();
    PartTable table{{tr("Kind"), tr("Support")}, {"divisions", "ratio", "radius"}, {}};
    for (std::size_t i = 0; i < session.model().curves.size(); ++i) {
        const auto& curve = session.model().curves[i];
        const Part part = CurveId(i);
        const std::string kind = curve.shape ? tr(word_of(curve.shape->kind)) : std::string();
        table.rows.push_back(
            {title(session, part), curve.id, part, {kind, support_word(curve.support, tr)}, numbers_of(session, part)});
    }
    return table;
}

PartTable table_of_regions(const Session& session)
{
    const ui::Catalogue& tr = session.tr();
    PartTable table{{tr("Material"), tr("Faces")}, {"thickness", "size"}, {}};
    const auto* const drawing = session.drawing();
    const auto faces = drawing != nullptr ? faces_of_regions(*drawing) : std::vector<std::vector<std::size_t>>{};
    for (std::size_t i = 0; i < session.model().regions.size(); ++i) {
        const auto& region = session.model().regions[i];
        const bool has_material = !region.is_hole && region.material.index < session.model().materials.size();
        TableRow row{{translatable("Region {id}"), {{"id", region.id}}}, region.id};
        row.words = {region.is_hole ? tr("Hole")
                     : has_material ? session.model()[region.material].id
                                    : std::string(),
                     i < faces.size() ? std::to_string(faces[i].size()) : std::string()};
        row.numbers = numbers(session.model(), RegionId(i));
        if (i < faces.size() && !faces[i].empty()) row.part = FacePlace{drawing->faces()[faces[i].front()].inside};
        table.rows.push_back(std::move(row));
    }
    return table;
}

PartTable table_of_materials(const Session& session)
{
    PartTable table{{}, {"E", "nu", "density", "alpha"}, {}};
    for (std::size_t i = 0; i < session.model().materials.size(); ++i) {
        const std::string& id = session.model().materials[i].id;
        table.rows.push_back(
            {{translatable("Material {id}"), {{"id", id}}}, id, {}, {}, numbers(session.model(), MaterialId(i))});
    }
    return table;
}

PartTable table_of_cases(const Session& session)
{
    const ui::Catalogue& tr = session.tr();
    PartTable table{{tr("Loads on points"), tr("Loads on curves")}, {"self-weight"}, {}};
    for (std::size_t i = 0; i < session.model().load_cases.size(); ++i) {
        const auto& load_case = session.model().load_cases[i];
        table.rows.push_back({title(session, femoop::CaseId(i)),
                              load_case.id,
                              {},
                              {std::to_string(load_case.points.size()), std::to_string(load_case.curves.size())},
                              numbers(session.model(), femoop::CaseId(i))});
    }
    return table;
}

/// A column for each case that takes part in one of them.
PartTable table_of_combinations(const Session& session)
{
    PartTable table;
    for (std::size_t i = session.model().load_cases.size(); i < session.model().n_cases(); ++i) {
        const femoop::CaseId id(i);
        table.rows.push_back({title(session, id), session.model().case_name(id), {}, {}, numbers(session.model(), id)});
        for (const Number& number : table.rows.back().numbers)
            if (std::ranges::find(table.ids, number.id) == table.ids.end()) table.ids.push_back(number.id);
    }
    return table;
}

TableRow row_of(const ReactionTable::Row& row)
{
    return {ui::Message(row.name), row.name, {}, {row.fx, row.fy, row.mz}, {}};
}

PartTable table_of_reactions(const Session& session)
{
    PartTable table{{"Rx", "Ry", session.tr()("M about its middle, of sums about the origin")}, {}, {}};
    const PlateInput input = session.input();
    if (input.result == nullptr) return table;
    const ReactionTable all = reaction_table(*input.result, session.units(), session.tr());
    for (const ReactionTable::Row& row : all.supports) table.rows.push_back(row_of(row));
    for (const ReactionTable::Row& row : {all.loads, all.reactions, all.sum}) table.rows.push_back(row_of(row));
    return table;
}

/// A click on a mode shows it.
PartTable table_of_modes(const Session& session)
{
    const ui::Catalogue& tr = session.tr();
    PartTable table{{tr("Frequency"), tr("Period"), tr("Mass along x"), tr("Mass along y")}, {}, {}};
    const auto* const modes = session.modes();
    for (std::size_t i = 0; modes != nullptr && i < modes->modes.size(); ++i) {
        const ModeTexts texts = mode_texts(*modes, i, session.options().numbers);
        const std::string name = std::to_string(i + 1);
        table.rows.push_back(
            {ui::Message(name), name, {}, {texts.frequency, texts.period, texts.shares[0], texts.shares[1]}, {}, i});
    }
    return table;
}

PartTable table_of(const Session& session, TableKind kind)
{
    switch (kind) {
    case TableKind::Points: return table_of_points(session);
    case TableKind::Curves: return table_of_curves(session);
    case TableKind::Regions: return table_of_regions(session);
    case TableKind::Materials: return table_of_materials(session);
    case TableKind::Cases: return table_of_cases(session);
    case TableKind::Combinations: return table_of_combinations(session);
    case TableKind::Modes: return table_of_modes(session);
    case TableKind::Reactions: break;
    }
    return table_of_reactions(session);
}

/// The heading of a column of numbers, from the first row that has one.
std::string heading_of(const Session& session, const PartTable& table, const std::string& id)
{
    for (const TableRow& row : table.rows)
        for (const Number& number : row.numbers)
            if (number.id == id) return shown(session, number).label;
    return "";
}

void show_row(Workspace& workspace, ui::NumberFields& fields, const PartTable& table, const TableRow& row)
{
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const bool is_selected = row.mode ? row.mode == workspace.session.look.mode
                                      : row.part && workspace.session.is_selected(*row.part);
    const bool is_chosen = ImGui::Selectable(ui::item_label(row.name, "name").c_str(), is_selected);
    if (is_chosen && row.mode) workspace.session.look.mode = *row.mode;
    if (is_chosen && row.part) {
        workspace.session.select(*row.part);
        workspace.topic = Topic::Properties;
    }
    for (const std::string& word : row.words) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(word.c_str());
    }
    for (const std::string& id : table.ids) {
        ImGui::TableNextColumn();
        const auto number = std::ranges::find(row.numbers, id, &Number::id);
        if (number == row.numbers.end()) continue;
        const ShownNumber field = shown(workspace.session, *number);
        const std::string text = number->value ? field.text : "–";
        take_number(workspace, fields, row.whose, *number,
                    fields.show("cell " + id, {.text = text,
                                               .exact_text = field.exact,
                                               .value = field.value,
                                               .width = ImGui::GetContentRegionAvail().x}));
    }
}

void show_table(Workspace& workspace, ui::NumberFields& fields)
{
    const PartTable table = table_of(workspace.session, *workspace.table);
    const int n_columns = 1 + static_cast<int>(table.words.size() + table.ids.size());
    constexpr ImGuiTableFlags look = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV |
                                     ImGuiTableFlags_SizingStretchProp;
    if (!ImGui::BeginTable("###rows", n_columns, look)) return;
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn(ui::shown_whole(workspace.tr()("Name")).c_str());
    for (const std::string& word : table.words) ImGui::TableSetupColumn(word.c_str());
    for (const std::string& id : table.ids)
        ImGui::TableSetupColumn((heading_of(workspace.session, table, id) + "###" + id).c_str());
    ImGui::TableHeadersRow();
    ImGuiListClipper rows;
    rows.Begin(static_cast<int>(table.rows.size()));
    while (rows.Step())
        for (int i = rows.DisplayStart; i < rows.DisplayEnd; ++i) {
            ImGui::PushID(i);
            show_row(workspace, fields, table, table.rows[static_cast<std::size_t>(i)]);
            ImGui::PopID();
        }
    ImGui::EndTable();
}

} // namespace

float TablesPanel::height(const Workspace& workspace, float room) const
{
    constexpr float ems = 13.0F, most = 0.5F;
    return workspace.table ? std::min(ems * ImGui::GetFontSize(), most * room) : 0.0F;
}

void TablesPanel::show(Workspace& workspace, const CommandTable& commands)
{
    const float em = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.6F * em, 0.3F * em});
    ImGui::BeginChild("###tables", {0.0F, 0.0F}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    ui::TabRow row;
    for (const TableEntry& entry : tables()) {
        const std::string label = workspace.tr()(entry.label) + "###" + std::string(entry.id);
        if (row.show(label, workspace.table == entry.value)) run(*commands.find(entry.id), workspace);
    }
    if (row.show(workspace.tr()("Close") + "###close tables", false)) run(*commands.find("table.show"), workspace);
    if (workspace.table) show_table(workspace, fields_);
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

} // namespace plane
