#include "ui/app/picture_area.h"

#include <imgui.h>

#include "ui/text/shortened.h"
#include "ui/widgets/panel.h"

namespace ui {

void picture_area(float bar, const std::function<void()>& picture)
{
    const ImVec2 room = ImGui::GetContentRegionAvail();
    ImGui::PushStyleColor(ImGuiCol_ChildBg, 0U);
    ImGui::BeginChild("###picture", {room.x, room.y - bar}, false, ImGuiWindowFlags_NoNav); // its keys are commands
    ImGui::PopStyleColor();
    picture();
    ImGui::EndChild();
}

void button_bar(const char* id, float height, const std::function<void()>& content)
{
    const float em = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.4F * em, 0.3F * em});
    ImGui::BeginChild(id, {0.0F, height}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NoScrollbar);
    content();
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

void status_bar(const std::string& text)
{
    begin_status_bar();
    ImGui::TextUnformatted(shortened(text, 400).c_str());
    end_status_bar();
}

} // namespace ui
