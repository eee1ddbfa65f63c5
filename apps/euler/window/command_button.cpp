#include "apps/euler/window/command_button.h"

#include <imgui.h>

#include <string>

namespace euler {

void command_button(Desk& desk, const CommandTable& commands, std::string_view id)
{
    const auto& command = *commands.find(id);
    const auto reason = why_not(command, desk);
    ImGui::BeginDisabled(reason.has_value());
    const bool is_clicked = ImGui::Button((label(command, desk, desk.session.tr()) + "###" + std::string(id)).c_str());
    ImGui::EndDisabled();
    if (reason && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        ImGui::SetTooltip("%s", desk.session.tr()(*reason).c_str());
    if (is_clicked) run(command, desk);
}

} // namespace euler
