#include "ui/widgets/field_row.h"

#include <imgui.h>

#include <algorithm>

namespace ui {

void begin_field_row(const std::string& name, const std::string& text)
{
    const float em = ImGui::GetFontSize(), end = ImGui::GetContentRegionMax().x;
    const float column = std::clamp(end - 6.0F * em, 3.0F * em, 6.5F * em);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(name.c_str());
    const float end_of_name = ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x;
    const float at = std::max(column, end_of_name + 0.5F * em);
    const float width = ImGui::CalcTextSize(text.c_str()).x + 2.0F * ImGui::GetStyle().FramePadding.x;
    if (at + width <= end) ImGui::SameLine(at);
}

} // namespace ui
