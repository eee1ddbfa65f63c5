#include "ui/widgets/number_grid.h"

#include <imgui.h>

#include <algorithm>

namespace ui {

float type_in_column(const NumberRows& rows, float width)
{
    float type = 1.0F;
    for (const auto& row : rows)
        for (const std::string& number : row) type = std::min(type, width / ImGui::CalcTextSize(number.c_str()).x);
    return type;
}

void number_grid(const char* id, const NumberRows& rows)
{
    const auto n_columns = rows.front().size();
    const float column = ImGui::GetContentRegionAvail().x / static_cast<float>(n_columns);
    const float type = type_in_column(rows, column - 2.0F * ImGui::GetStyle().CellPadding.x - 1.0F);
    if (!ImGui::BeginTable(id, static_cast<int>(n_columns),
                           ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_BordersInnerV))
        return;
    ImGui::SetWindowFontScale(type);
    for (const auto& row : rows) {
        ImGui::TableNextRow();
        for (const std::string& number : row) {
            ImGui::TableNextColumn();
            const float shift = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(number.c_str()).x;
            ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, shift));
            ImGui::TextUnformatted(number.c_str());
        }
    }
    ImGui::SetWindowFontScale(1.0F);
    ImGui::EndTable();
}

} // namespace ui
