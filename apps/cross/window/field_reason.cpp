#include "apps/cross/window/field_reason.h"

#include <imgui.h>

#include <algorithm>

namespace cross {

void show_reason(const std::string& reason, ui::Point middle, double left)
{
    const float em = ImGui::GetFontSize(), wrap = 24.0F * em, margin = 0.4F * em;
    const ImVec2 size = ImGui::CalcTextSize(reason.c_str(), nullptr, false, wrap);
    const float first = static_cast<float>(left) + margin;
    const float last = std::max(first, ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - size.x - margin);
    const ImVec2 at(std::clamp(static_cast<float>(middle.x) - 0.5F * size.x, first, last),
                    static_cast<float>(middle.y) + 0.6F * ImGui::GetFrameHeight() + margin);
    const ImVec2 low(at.x - margin, at.y - margin), high(at.x + size.x + margin, at.y + size.y + margin);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_PopupBg));
    list.AddRect(low, high, ImGui::GetColorU32(ImGuiCol_Border));
    list.AddText(ImGui::GetFont(), em, at, ImGui::GetColorU32(ImGuiCol_Text), reason.c_str(), nullptr, wrap);
}

} // namespace cross
