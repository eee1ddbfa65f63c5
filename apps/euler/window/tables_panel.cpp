#include "apps/euler/window/tables_panel.h"

#include <imgui.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "apps/euler/document/step_tables.h"
#include "ui/widgets/panel.h"

namespace euler {

using topology::RowMark;
using topology::TableCell;
using topology::TableKind;
using topology::TableRow;
using ui::translatable;

namespace {

ImU32 packed(ui::Color color) { return IM_COL32(color.r, color.g, color.b, color.a); }

/// Writes the rows of one table.
class RowWriter {
public:
    RowWriter(Session& session, std::size_t solid) : session_(session), solid_(solid), theme_(session.look.theme) {}

    void write(const std::optional<TableRow>& row, std::size_t n_cells, const char* side)
    {
        ImGui::PushID(side);
        if (!row) {
            for (std::size_t i = 0; i <= n_cells; ++i) ImGui::TableNextColumn();
        } else {
            const bool is_selected = row->entity && session_.selection == Part{solid_, *row->entity};
            number(*row, {row->label, row->number, row->entity, false}, is_selected, -1);
            for (std::size_t i = 0; i < std::min(row->cells.size(), n_cells); ++i)
                number(*row, row->cells[i], is_selected, static_cast<int>(i));
        }
        ImGui::PopID();
    }

private:
    ImU32 ink(RowMark mark) const
    {
        if (mark == RowMark::Created) return packed(theme_[ui::Role::Created].text);
        if (mark == RowMark::Killed) return packed(theme_[ui::Role::Killed].text);
        return ImGui::GetColorU32(ImGuiCol_Text);
    }

    // It leads to its entity; where a pointer is to be mended it begins the answer too.
    void take(const TableRow& row, const TableCell& cell)
    {
        session_.selection = Part{solid_, *cell.link};
        if (session_.game() && std::holds_alternative<CorruptedPointer>(session_.game()->task()))
            session_.typed_answer() = std::string(row.label) + " " + std::to_string(row.number) + " " +
                                      std::string(cell.label) + " ";
    }

    // A number that leads somewhere.
    void number(const TableRow& row, const TableCell& cell, bool is_selected, int id)
    {
        ImGui::TableNextColumn();
        if (is_selected) ImGui::TableSetBgColor(ImGuiTableBgTarget_CellBg, ImGui::GetColorU32(ImGuiCol_Header));
        if (cell.is_changed) {
            const ui::Color lit = ui::with_opacity(theme_[ui::Role::Changed].stroke.color, 0.28);
            ImGui::TableSetBgColor(ImGuiTableBgTarget_CellBg, packed(lit));
        }
        const std::string text = std::to_string(cell.number) + "###" + std::to_string(id);
        ImGui::PushStyleColor(ImGuiCol_Text, ink(row.mark));
        if (cell.link) {
            if (ImGui::Selectable(text.c_str())) take(row, cell);
            if (ImGui::IsItemHovered()) session_.hover = Part{solid_, *cell.link};
        } else {
            ImGui::Text("%zu", cell.number);
        }
        ImGui::PopStyleColor();
    }

    Session& session_;
    std::size_t solid_;
    ui::Theme theme_;
};

} // namespace

void TablesPanel::bring_changed_forward(Workspace& workspace) const
{
    workspace.table = workspace.wanted_table;
    const auto changes = [&](const TableEntry& entry) { return tables_.first_changed(entry.value).has_value(); };
    if (tables_.first_changed(workspace.table)) return;
    const auto first = std::ranges::find_if(euler::tables(), changes);
    if (first != euler::tables().end()) workspace.table = first->value;
}

void TablesPanel::follow(Workspace& workspace)
{
    const Session& session = workspace.session;
    const bool is_over = session.game() && session.game()->is_over();
    if (std::exchange(seen_, workspace.table) != workspace.table) is_new_ = true;
    if (std::exchange(is_over_, is_over) != is_over) is_new_ = true;
    if (std::exchange(generation_, session.generation()) == session.generation()) return;
    const StepReport* const step = session.report();
    solid_ = step == nullptr ? 0 : step->solid;
    tables_ = step == nullptr ? topology::ComparedTables() : step_tables(session.before(), session.after(), solid_);
    const bool is_broken = session.game() && std::holds_alternative<CorruptedPointer>(session.game()->task());
    broken_ = is_broken && step == nullptr
                  ? topology::EntityRows(std::get<CorruptedPointer>(session.game()->task()).broken)
                  : topology::EntityRows();
    winged_ = step == nullptr ? topology::WingedTables() : topology::WingedTables(*session.after()[solid_].solid);
    bring_changed_forward(workspace);
    is_new_ = true;
}

void TablesPanel::show(Workspace& workspace)
{
    follow(workspace);
    const float em = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.6F * em, 0.3F * em});
    ImGui::BeginChild("###tables", {}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.4F * em, 0.2F * em});
    show_tabs(workspace);
    if (workspace.structure == Structure::WingedEdges) show_winged(workspace.session);
    else show_table(workspace.session, workspace.table);
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

// A dot tells which tables the step has changed.
void TablesPanel::show_tabs(Workspace& workspace) const
{
    ui::TabRow row;
    for (const TableEntry& entry : euler::tables()) {
        const bool is_changed = tables_.first_changed(entry.value).has_value();
        const std::string title = workspace.session.tr()(entry.label) + (is_changed ? " •" : "");
        const bool is_chosen = workspace.structure == Structure::HalfEdges && entry.value == workspace.table;
        if (row.show(title + "###" + std::string(entry.id), is_chosen)) workspace.show_table(entry.value);
    }
    const std::string winged = workspace.session.tr()("Winged edges") + "###table.winged";
    if (row.show(winged, workspace.structure == Structure::WingedEdges)) workspace.structure = Structure::WingedEdges;
}

void TablesPanel::headings(const Session& session, const TableRow& like) const
{
    const ui::Catalogue& tr = session.tr();
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    for (const std::string_view when : {translatable("before"), translatable("after")}) {
        ImGui::TableNextColumn();
        const std::string title = tr(when) + ": " + std::string(like.label);
        ImGui::TextDisabled("%s", title.c_str());
        for (const TableCell& cell : like.cells) {
            ImGui::TableNextColumn();
            ImGui::TextDisabled("%s", std::string(cell.label).c_str());
        }
    }
}

namespace {

constexpr ImGuiTableFlags table_look = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV |
                                       ImGuiTableFlags_SizingStretchSame;

// A solid may have a million rows; those in sight are written.
void write_rows(std::size_t n_rows, const std::function<void(std::size_t)>& write)
{
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(n_rows));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            ImGui::TableNextRow();
            ImGui::PushID(i);
            write(static_cast<std::size_t>(i));
            ImGui::PopID();
        }
    }
}

// The row with some before it.
void bring_into_sight(std::size_t row)
{
    constexpr std::size_t n_before = 2;
    const float height = ImGui::GetTextLineHeight() + 2.0F * ImGui::GetStyle().CellPadding.y;
    ImGui::SetScrollY(height * static_cast<float>(row - std::min(row, n_before)));
}

} // namespace

void TablesPanel::show_table(Session& session, TableKind kind)
{
    if (broken_.size(kind) != 0) return show_broken(session, kind);
    const std::size_t n_rows = tables_.size(kind);
    if (n_rows == 0) return ImGui::TextDisabled("%s", session.tr()("Nothing is done yet.").c_str());
    const topology::ComparedRow first = tables_(kind, 0);
    const TableRow& like = first.after ? *first.after : *first.before;
    const std::size_t n_cells = like.cells.size();
    if (!ImGui::BeginTable("rows", 2 * (1 + static_cast<int>(n_cells)), table_look)) return;
    ImGui::TableSetupScrollFreeze(0, 1);
    headings(session, like);
    RowWriter writer(session, solid_);
    write_rows(n_rows, [&](std::size_t row) {
        const topology::ComparedRow both = tables_(kind, row);
        writer.write(both.before, n_cells, "before");
        writer.write(both.after, n_cells, "after");
    });
    if (const auto row = tables_.first_changed(kind); std::exchange(is_new_, false) && row) bring_into_sight(*row);
    ImGui::EndTable();
}

void TablesPanel::show_broken(Session& session, TableKind kind)
{
    const auto row = [&](std::size_t i) { return broken_(kind, i); };
    const std::size_t n = broken_.size(kind);
    TablePlace place{"broken", 0.0F};
    if (std::exchange(is_new_, false) && session.selection)
        for (std::size_t i = 0; i < n; ++i)
            if (row(i).entity == session.selection->entity) place.wanted_row = i;
    lone_table(session, n, row(0).cells.size(), row, place);
}

// The same solid as edges that carry all the links: edges, vertices and faces beside one another.
void TablesPanel::show_winged(Session& session)
{
    constexpr std::size_t n_of_edge = 8, n_of_vertex = 1, most_of_face = 12; // a face has a cell for each of its loops
    const float room = ImGui::GetContentRegionAvail().x;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const std::size_t n_of_face = std::min(winged_.most_loops(), most_of_face);
    lone_table(session, winged_.n_edges(), n_of_edge, [&](std::size_t i) { return winged_.edge(i); },
               {"winged edges", 0.66F * room - gap});
    ImGui::SameLine();
    lone_table(session, winged_.n_vertices(), n_of_vertex, [&](std::size_t i) { return winged_.vertex(i); },
               {"winged vertices", 0.14F * room - gap});
    ImGui::SameLine();
    lone_table(session, winged_.n_faces(), n_of_face, [&](std::size_t i) { return winged_.face(i); },
               {"winged faces", 0.2F * room - gap});
}

void TablesPanel::lone_table(Session& session, std::size_t n_rows, std::size_t n_cells, const MakeRow& row,
                             const TablePlace& place) const
{
    if (n_rows == 0 || !ImGui::BeginTable(place.id, 1 + static_cast<int>(n_cells), table_look, {place.width, 0.0F}))
        return ImGui::Dummy({place.width, 1.0F});
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::TableNextColumn();
    const TableRow first = row(0);
    ImGui::TextDisabled("%s", std::string(first.label).c_str());
    for (const TableCell& cell : first.cells) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", std::string(cell.label).c_str());
    }
    RowWriter writer(session, solid_);
    write_rows(n_rows, [&](std::size_t i) { writer.write(row(i), n_cells, "row"); });
    if (place.wanted_row) bring_into_sight(*place.wanted_row);
    ImGui::EndTable();
}

} // namespace euler
