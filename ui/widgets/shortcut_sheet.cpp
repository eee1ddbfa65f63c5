#include "ui/widgets/shortcut_sheet.h"

#include <imgui.h>

#include <span>

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

} // namespace

void shortcut_sheet(const std::vector<KeyLine>& lines, const Catalogue& tr, bool& is_open)
{
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(viewport.GetCenter(), ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::Begin((tr("Keys") + "###shortcuts").c_str(), &is_open,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse);
    const float row = ImGui::GetTextLineHeight() + 2.0F * ImGui::GetStyle().CellPadding.y;
    const auto n_most = static_cast<std::size_t>(std::max(1.0F, 0.8F * viewport.WorkSize.y / row));
    const std::size_t n_columns = lines.size() / n_most + 1;
    const std::size_t n_rows = lines.size() / n_columns + 1; // columns of like length
    std::size_t n_shown = 0;
    while (n_shown < lines.size()) {
        if (n_shown > 0) ImGui::SameLine(0.0F, 2.0F * ImGui::GetFontSize());
        const auto column = next_column(std::span(lines).subspan(n_shown), n_rows);
        key_column(column, ("keys" + std::to_string(n_shown)).c_str());
        n_shown += column.size();
    }
    ImGui::End();
}

} // namespace ui
