#include "apps/frame/window/document_tabs.h"

#include <imgui.h>

#include <optional>
#include <string>

#include "apps/frame/session/tabs.h"
#include "ui/widgets/item_label.h"

namespace frame {

void document_tabs(Workspace& workspace)
{
    if (n_tabs(workspace) < 2) return;
    std::optional<std::size_t> chosen;
    for (std::size_t i = 0; i < n_tabs(workspace); ++i) {
        const Session& session = tab(workspace, i);
        const std::string title = (session.is_dirty() ? "* " : "") + tab_name(workspace, i);
        const bool is_shown = i == workspace.tab;
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(is_shown ? ImGuiCol_TabActive : ImGuiCol_Tab));
        if (ImGui::Button(ui::item_label(title, "tab" + std::to_string(i)).c_str())) chosen = i;
        ImGui::PopStyleColor();
        if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Middle)) {
            chosen = i;
            workspace.requests.push_back(Request::CloseTab);
        }
        ImGui::SameLine(0.0F, 0.2F * ImGui::GetFontSize());
    }
    ImGui::NewLine();
    if (chosen) show_tab(workspace, *chosen);
}

} // namespace frame
