#include "apps/frame/window/truss_panel.h"

#include <imgui.h>

#include "apps/frame/session/truss_commands.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

namespace {

/// As a button of the panel's width. \returns whether it is clicked
bool stage_button(const std::string& words, bool is_shown)
{
    const ImVec2 corner = ImGui::GetCursorPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 size = ImGui::CalcTextSize(words.c_str(), nullptr, false, width);
    ImVec4 hovered = ImGui::GetStyleColorVec4(ImGuiCol_HeaderHovered); // paler than the one that is shown
    if (!is_shown) hovered.w *= 0.35F;
    ImGui::PushStyleColor(ImGuiCol_HeaderHovered, hovered);
    const bool is_clicked = ImGui::Selectable("###stage", is_shown, ImGuiSelectableFlags_None, {width, size.y});
    ImGui::PopStyleColor();
    if (is_shown && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
    ImGui::SetCursorPos(corner);
    ui::wrapped_text(words);
    return is_clicked;
}

} // namespace

void truss_panel(Workspace& workspace)
{
    Session& session = workspace.session;
    const TrussPicture& truss = *shown_truss(session);
    ImGui::TextDisabled("%s", method_name(truss.method, session.view.tr).c_str());
    for (std::size_t i = 0; i < truss.stages.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        if (stage_button(truss.stages[i].title, i + 1 == truss.n_stages)) session.truss.go_to(i + 1);
        ImGui::PopID();
    }
}

} // namespace frame
