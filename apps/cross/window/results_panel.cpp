#include "apps/cross/window/results_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "apps/cross/session/report.h"
#include "ui/widgets/item_label.h"
#include "ui/widgets/panel.h"
#include "ui/widgets/wrapped_text.h"

namespace cross {

namespace {

void show_cell(const std::string& text, bool is_name)
{
    const float shift = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(text.c_str()).x;
    if (!is_name && shift > 0.0F) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + shift);
    ImGui::TextUnformatted(text.c_str());
}

/// The names and so many of the further columns.
tabular::Table part_of(const tabular::Table& whole, std::size_t begin, std::size_t n)
{
    std::vector<std::size_t> columns{0};
    for (std::size_t i = begin; i < std::min(begin + n, whole.columns.size()); ++i) columns.push_back(i);
    return columns_of(whole, columns);
}

/// Buttons that go to the columns before and after.
void turn_pages(Workspace& workspace, const tabular::Table& table, std::size_t n)
{
    const std::size_t last = table.columns.size() - 1;
    workspace.first_column = std::clamp<std::size_t>(workspace.first_column, 1, last / n * n + 1);
    const auto button = [&](const char* words, bool can, std::size_t to) {
        ImGui::BeginDisabled(!can);
        if (ImGui::Button(words)) workspace.first_column = to;
        ImGui::EndDisabled();
        ImGui::SameLine();
    };
    const std::size_t first = workspace.first_column, end = std::min(last, first + n - 1);
    button("<###columns before", first > 1, first > n ? first - n : 1);
    button(">###columns after", end < last, first + n);
    const std::string words = workspace.tr()(
        "{first} to {last}, of {n}",
        {{"first", table.columns[first].label()}, {"last", table.columns[end].label()}, {"n", std::to_string(last)}});
    ImGui::TextUnformatted(words.c_str());
}

/// Of what stands in a column.
float width_of(const tabular::Table& table, std::size_t column)
{
    float widest = ImGui::CalcTextSize(table.columns[column].label().c_str()).x;
    for (const auto& row : table.rows)
        widest = std::max(widest, ImGui::CalcTextSize(row.cells[column].shown.c_str()).x);
    return std::ceil(widest);
}

float padded_width_of(const tabular::Table& table, std::size_t column)
{
    return width_of(table, column) + 2.0F * ImGui::GetStyle().CellPadding.x + 1.0F;
}

/// Where the parts of a table begin that have room beside one another; the last is past its end.
std::vector<std::size_t> beginnings(const tabular::Table& table, float room)
{
    const float names = padded_width_of(table, 0);
    std::vector<std::size_t> begins{1};
    float taken = names;
    for (std::size_t i = 1; i < table.columns.size(); ++i) {
        const float width = padded_width_of(table, i);
        if (taken + width > room && i > begins.back()) {
            begins.push_back(i);
            taken = names;
        }
        taken += width;
    }
    begins.push_back(table.columns.size());
    return begins;
}

void show_rows(const tabular::Table& table)
{
    // Dear ImGui itself knows how broad columns are only a frame later.
    const std::vector<std::string> names = labels(table);
    for (std::size_t i = 0; i < names.size(); ++i)
        ImGui::TableSetupColumn(ui::shown_whole(names[i]).c_str(), ImGuiTableColumnFlags_WidthFixed,
                                width_of(table, i));
    ImGui::TableHeadersRow();
    for (const auto& row : table.rows) {
        ImGui::TableNextRow();
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
            ImGui::TableNextColumn();
            show_cell(row.cells[i].shown, i == 0);
        }
    }
}

/// One part below the other, each with the names of the rows.
void show_parts(const tabular::Table& table, const std::vector<std::size_t>& begins)
{
    constexpr auto flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingFixedFit;
    if (ImGui::BeginChild("###parts")) {
        for (std::size_t i = 0; i + 1 < begins.size(); ++i) {
            const tabular::Table part = part_of(table, begins[i], begins[i + 1] - begins[i]);
            ImGui::PushID(static_cast<int>(i));
            if (ImGui::BeginTable("###part", static_cast<int>(part.columns.size()),
                                  flags | ImGuiTableFlags_NoHostExtendX)) {
                show_rows(part);
                ImGui::EndTable();
            }
            ImGui::PopID();
            ImGui::Spacing();
        }
    }
    ImGui::EndChild();
}

/// The names of the rows broken into lines, so that numbers have most of the room.
tabular::Table with_narrow_names(tabular::Table table, float room)
{
    constexpr float most = 0.5F;
    if (table.columns.empty() || width_of(table, 0) <= most * room) return table;
    for (auto& row : table.rows) row.cells[0].shown = ui::in_lines(row.cells[0].shown, most * room);
    return table;
}

void show_table(Workspace& workspace, const tabular::Table& whole)
{
    for (const std::string& note : whole.notes) ui::wrapped_text(note);
    if (whole.columns.empty()) return;
    constexpr std::size_t most_cells = 4000; // that are measured in every frame
    if (whole.columns.size() > 1 && whole.columns.size() * whole.rows.size() <= most_cells) {
        const auto begins = beginnings(whole, ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize);
        if (begins.size() > 2) return show_parts(whole, begins);
    }
    constexpr std::size_t most_columns = 64, shown = 48; // of Dear ImGui's tables
    const bool is_cut = whole.columns.size() > most_columns;
    if (is_cut) turn_pages(workspace, whole, shown);
    const tabular::Table table = is_cut ? part_of(whole, workspace.first_column, shown)
                                        : part_of(whole, 1, most_columns);
    const auto flags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                       ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingFixedFit;
    if (!ImGui::BeginTable("###table", static_cast<int>(table.columns.size()), flags)) return;
    ImGui::TableSetupScrollFreeze(1, 1);
    show_rows(table);
    ImGui::EndTable();
}

} // namespace

void results_panel(Workspace& workspace, const CommandTable& commands)
{
    ui::TabRow row;
    for (const TopicEntry& entry : topics()) {
        const std::string title = workspace.tr()(entry.label) + "###" + std::string(entry.id);
        if (row.show(title, entry.value == workspace.topic)) run(*commands.find(entry.id), workspace);
    }
    ImGui::Separator();
    if (workspace.topic != Topic::Exercises && workspace.session.solution().task)
        show_table(workspace,
                   with_narrow_names(table_of(workspace.session, workspace.topic), ImGui::GetContentRegionAvail().x));
}

} // namespace cross
