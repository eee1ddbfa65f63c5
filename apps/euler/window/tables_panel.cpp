#include "apps/euler/window/tables_panel.h"

#include <imgui.h>

#include <algorithm>
#include <functional>
#include <span>
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

/// An entity's row before and after a step.
struct RowPair {
    const TableRow* before = nullptr;
    const TableRow* after = nullptr;
};

// In the order of the numbers, which both are in.
std::vector<RowPair> paired(const std::vector<TableRow>& before, const std::vector<TableRow>& after)
{
    std::vector<RowPair> pairs;
    for (auto a = before.begin(), b = after.begin(); a != before.end() || b != after.end();) {
        const bool takes_a = b == after.end() || (a != before.end() && a->number <= b->number);
        const bool takes_b = a == before.end() || (b != after.end() && b->number <= a->number);
        pairs.push_back({takes_a ? &*a : nullptr, takes_b ? &*b : nullptr});
        if (takes_a) ++a;
        if (takes_b) ++b;
    }
    return pairs;
}

/// Writes the rows of one table.
class RowWriter {
public:
    RowWriter(Session& session, std::size_t solid) : session_(session), solid_(solid), theme_(session.look.theme) {}

    void write(const TableRow* row, std::size_t n_cells, const char* side)
    {
        ImGui::PushID(side);
        if (row == nullptr) {
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
        if (session_.game() && std::holds_alternative<BrokenPointer>(session_.game()->task()))
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

bool is_touched(const RowPair& pair)
{
    const auto touched = [](const TableRow* row) { return row != nullptr && row->mark != RowMark::Same; };
    return touched(pair.before) || touched(pair.after);
}

} // namespace

void TablesPanel::follow(const Session& session)
{
    if (std::exchange(generation_, session.generation()) == session.generation()) return;
    const StepReport* const step = session.report();
    tables_ = step == nullptr ? topology::ComparedTables() : step_tables(session.stepper(), session.step());
    solid_ = step == nullptr ? 0 : step->solid;
    const bool is_broken = session.game() && std::holds_alternative<BrokenPointer>(session.game()->task());
    broken_ = is_broken && step == nullptr
                  ? topology::entity_tables(std::get<BrokenPointer>(session.game()->task()).broken)
                  : topology::EntityTables();
    winged_ = step == nullptr ? topology::WingedTables() : topology::winged_tables(session.after()[solid_].solid);
    is_new_ = true;
}

void TablesPanel::show(Desk& desk)
{
    follow(desk.session);
    const float em = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.6F * em, 0.3F * em});
    ImGui::BeginChild("###tables", {}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.4F * em, 0.2F * em});
    show_tabs(desk);
    if (desk.structure == Structure::WingedEdges) show_winged(desk.session);
    else show_table(desk.session, desk.table);
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

// A dot tells which tables the step has changed.
void TablesPanel::show_tabs(Desk& desk) const
{
    const auto is_same = [](const TableRow& row) { return row.mark == RowMark::Same; };
    ui::TabRow row;
    for (const TableEntry& entry : euler::tables()) {
        const bool is_changed = !std::ranges::all_of(tables_.after[entry.table], is_same) ||
                                !std::ranges::all_of(tables_.before[entry.table], is_same);
        const std::string title = desk.session.tr()(entry.label) + (is_changed ? " •" : "");
        const bool is_chosen = desk.structure == Structure::HalfEdges && entry.table == desk.table;
        if (!row.show(title + "###" + std::string(entry.id), is_chosen)) continue;
        desk.table = entry.table;
        desk.structure = Structure::HalfEdges;
    }
    const std::string winged = desk.session.tr()("Winged edges") + "###table.winged";
    if (row.show(winged, desk.structure == Structure::WingedEdges)) desk.structure = Structure::WingedEdges;
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

// A solid may have a hundred thousand rows; those in sight are written.
void write_rows(std::span<const RowPair> pairs, const std::function<void(const RowPair&)>& write)
{
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(pairs.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            ImGui::TableNextRow();
            ImGui::PushID(i);
            write(pairs[static_cast<std::size_t>(i)]);
            ImGui::PopID();
        }
    }
}

// The first row that a step changed, with some before it.
void bring_into_sight(std::span<const RowPair> pairs)
{
    const auto touched = std::ranges::find_if(pairs, is_touched);
    if (touched == pairs.end()) return;
    constexpr std::ptrdiff_t n_before = 2;
    const std::ptrdiff_t row = std::max<std::ptrdiff_t>(0, touched - pairs.begin() - n_before);
    const float height = ImGui::GetTextLineHeight() + 2.0F * ImGui::GetStyle().CellPadding.y;
    ImGui::SetScrollY(height * static_cast<float>(row));
}

} // namespace

void TablesPanel::show_table(Session& session, TableKind kind)
{
    if (!broken_[kind].empty()) return show_broken(session, kind);
    const std::vector<RowPair> pairs = paired(tables_.before[kind], tables_.after[kind]);
    if (pairs.empty()) return ImGui::TextDisabled("%s", session.tr()("Nothing is done yet.").c_str());
    const TableRow& like = pairs.front().after != nullptr ? *pairs.front().after : *pairs.front().before;
    const std::size_t n_cells = like.cells.size();
    if (!ImGui::BeginTable("rows", 2 * (1 + static_cast<int>(n_cells)), table_look)) return;
    ImGui::TableSetupScrollFreeze(0, 1);
    headings(session, like);
    RowWriter writer(session, solid_);
    write_rows(pairs, [&](const RowPair& pair) {
        writer.write(pair.before, n_cells, "before");
        writer.write(pair.after, n_cells, "after");
    });
    if (std::exchange(is_new_, false)) bring_into_sight(pairs);
    ImGui::EndTable();
}

void TablesPanel::show_broken(Session& session, TableKind kind) const
{
    winged_table(session, broken_[kind], {"broken", 0.0F});
}

// The same solid as edges that carry all the links: edges, vertices and faces beside one another.
void TablesPanel::show_winged(Session& session)
{
    const float room = ImGui::GetContentRegionAvail().x;
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    winged_table(session, winged_.edges, {"winged edges", 0.66F * room - gap});
    ImGui::SameLine();
    winged_table(session, winged_.vertices, {"winged vertices", 0.14F * room - gap});
    ImGui::SameLine();
    winged_table(session, winged_.faces, {"winged faces", 0.2F * room - gap});
}

void TablesPanel::winged_table(Session& session, const std::vector<TableRow>& rows, const TablePlace& place) const
{
    std::size_t n_cells = 0; // a face has a cell for each of its loops
    for (const TableRow& row : rows) n_cells = std::max(n_cells, row.cells.size());
    constexpr std::size_t most_cells = 12;
    n_cells = std::min(n_cells, most_cells);
    if (n_cells == 0 || !ImGui::BeginTable(place.id, 1 + static_cast<int>(n_cells), table_look, {place.width, 0.0F}))
        return ImGui::Dummy({place.width, 1.0F});
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", std::string(rows.front().label).c_str());
    for (const TableCell& cell : rows.front().cells) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", std::string(cell.label).c_str());
    }
    RowWriter writer(session, solid_);
    write_rows(paired({}, rows), [&](const RowPair& pair) { writer.write(pair.after, n_cells, "row"); });
    ImGui::EndTable();
}

} // namespace euler
