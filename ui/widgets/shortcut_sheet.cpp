#include "ui/widgets/shortcut_sheet.h"

#include <imgui.h>

#include <algorithm>
#include <span>
#include <string>
#include <utility>

namespace ui {

namespace {

// As many lines as have room below one another; a menu's title stays with its first command.
std::span<const KeyLine> next_column(std::span<const KeyLine> lines, std::size_t n_most)
{
    if (lines.size() <= n_most) return lines;
    const bool ends_with_title = n_most > 1 && lines[n_most - 1].key.empty();
    return lines.first(ends_with_title ? n_most - 1 : n_most);
}

void key_column(std::span<const KeyLine> lines, const char* id)
{
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit |
                                      ImGuiTableFlags_NoHostExtendX;
    if (!ImGui::BeginTable(id, 2, flags)) return;
    for (const KeyLine& line : lines) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(line.key.c_str());
        ImGui::TableNextColumn();
        if (line.key.empty()) ImGui::TextDisabled("%s", line.words.c_str());
        else ImGui::TextUnformatted(line.words.c_str());
    }
    ImGui::EndTable();
}

float column_width(std::span<const KeyLine> lines)
{
    float key = 0.0F;
    float words = 0.0F;
    for (const KeyLine& line : lines) {
        key = std::max(key, ImGui::CalcTextSize(line.key.c_str()).x);
        words = std::max(words, ImGui::CalcTextSize(line.words.c_str()).x);
    }
    return key + words + 4.0F * ImGui::GetStyle().CellPadding.x;
}

float gap() { return 2.0F * ImGui::GetFontSize(); }

using Columns = std::vector<std::span<const KeyLine>>;

Columns cut(std::span<const KeyLine> lines, std::size_t n_rows)
{
    Columns columns;
    while (!lines.empty()) {
        columns.push_back(next_column(lines, n_rows));
        lines = lines.subspan(columns.back().size());
    }
    return columns;
}

/// The shortest columns that are no more than so many.
Columns in_columns(std::span<const KeyLine> lines, std::size_t n_columns)
{
    std::size_t n_rows = (lines.size() + n_columns - 1) / n_columns;
    Columns columns = cut(lines, n_rows);
    while (columns.size() > n_columns) columns = cut(lines, ++n_rows);
    return columns;
}

float width(const Columns& columns)
{
    float sum = -gap();
    for (const auto& column : columns) sum += column_width(column) + gap();
    return sum;
}

/// As few as keep the sheet within the room's height, but no more than its width takes: then it scrolls.
Columns fitted_columns(std::span<const KeyLine> lines, ImVec2 room)
{
    const float row = ImGui::GetTextLineHeight() + 2.0F * ImGui::GetStyle().CellPadding.y;
    Columns columns = in_columns(lines, 1);
    while (row * static_cast<float>(columns.front().size()) > room.y) {
        Columns more = in_columns(lines, columns.size() + 1);
        if (more.size() == columns.size() || width(more) > room.x) break;
        columns = std::move(more);
    }
    return columns;
}

} // namespace

void shortcut_sheet(const std::vector<KeyLine>& lines, const Catalogue& tr, bool& is_open)
{
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::SetNextWindowPos(viewport.GetWorkCenter(), ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSizeConstraints({}, viewport.WorkSize);
    ImGui::Begin((tr("Keys") + "###shortcuts").c_str(), &is_open,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse);
    const ImVec2 room{viewport.WorkSize.x - 2.0F * style.WindowPadding.x - style.ScrollbarSize,
                      viewport.WorkSize.y - 2.0F * style.WindowPadding.y - ImGui::GetFrameHeight()};
    if (!lines.empty()) {
        int n_shown = 0;
        for (const auto& column : fitted_columns(lines, room)) {
            if (n_shown > 0) ImGui::SameLine(0.0F, gap());
            key_column(column, ("keys" + std::to_string(n_shown++)).c_str());
        }
    }
    ImGui::End();
}

} // namespace ui
