#include "apps/cross/window/results_panel.h"

#include <imgui.h>

#include <algorithm>

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
TextTable part_of(const TextTable& whole, std::size_t begin, std::size_t n)
{
    const auto cut = [&](const std::vector<std::string>& row) {
        std::vector<std::string> cells{row.front()};
        for (std::size_t i = begin; i < std::min(begin + n, row.size()); ++i) cells.push_back(row[i]);
        return cells;
    };
    TextTable part{.notes = {}, .head = cut(whole.head)};
    for (const auto& row : whole.rows) part.rows.push_back(cut(row));
    return part;
}

/// Buttons that go to the columns before and after.
void turn_pages(Desk& desk, const TextTable& table, std::size_t n)
{
    const std::size_t last = table.head.size() - 1;
    desk.first_column = std::clamp<std::size_t>(desk.first_column, 1, last / n * n + 1);
    const auto button = [&](const char* words, bool can, std::size_t to) {
        ImGui::BeginDisabled(!can);
        if (ImGui::Button(words)) desk.first_column = to;
        ImGui::EndDisabled();
        ImGui::SameLine();
    };
    const std::size_t first = desk.first_column, end = std::min(last, first + n - 1);
    button("<###columns before", first > 1, first > n ? first - n : 1);
    button(">###columns after", end < last, first + n);
    const std::string words = desk.tr()(
        "{first} to {last}, of {n}",
        {{"first", table.head[first]}, {"last", table.head[end]}, {"n", std::to_string(last)}});
    ImGui::TextUnformatted(words.c_str());
}

void show_table(Desk& desk, const TextTable& whole)
{
    for (const std::string& note : whole.notes) ui::wrapped_text(note);
    if (whole.head.empty()) return;
    constexpr std::size_t most_columns = 64, shown = 48; // of Dear ImGui's tables
    const bool is_cut = whole.head.size() > most_columns;
    if (is_cut) turn_pages(desk, whole, shown);
    const TextTable table = is_cut ? part_of(whole, desk.first_column, shown) : part_of(whole, 1, most_columns);
    const auto flags = ImGuiTableFlags_ScrollX | ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg |
                       ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingFixedFit;
    if (!ImGui::BeginTable("###table", static_cast<int>(table.head.size()), flags)) return;
    ImGui::TableSetupScrollFreeze(1, 1);
    for (const std::string& name : table.head) ImGui::TableSetupColumn(ui::shown_whole(name).c_str());
    ImGui::TableHeadersRow();
    for (const auto& row : table.rows) {
        ImGui::TableNextRow();
        for (std::size_t i = 0; i < row.size(); ++i) {
            ImGui::TableNextColumn();
            show_cell(row[i], i == 0);
        }
    }
    ImGui::EndTable();
}

} // namespace

void results_panel(Desk& desk, const CommandTable& commands)
{
    ui::TabRow row;
    for (const TopicEntry& entry : topics()) {
        const std::string title = desk.tr()(entry.label) + "###" + std::string(entry.id);
        if (row.show(title, entry.topic == desk.topic)) run(*commands.find(entry.id), desk);
    }
    ImGui::Separator();
    if (desk.topic != Topic::Exercises && desk.session.solution().task)
        show_table(desk, table_of(desk.session, desk.topic));
}

} // namespace cross
