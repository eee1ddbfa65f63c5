#include "apps/mohr/window/construction_panel.h"

#include <imgui.h>

#include <string>

#include "apps/mohr/view/construction_words.h"
#include "ui/widgets/command_menu.h"
#include "ui/widgets/wrapped_text.h"

namespace mohr {

namespace {

/// A sentence that is clicked; the step that is shown is bold.
void step_row(Session& session, std::size_t number, const std::string& words, ui::ImGuiSession& gui)
{
    const bool is_now = session.step() == number;
    ImGui::PushFont(is_now ? gui.bold() : gui.regular());
    const ImVec2 begin = ImGui::GetCursorScreenPos();
    ui::wrapped_text(words);
    const float height = ImGui::GetCursorScreenPos().y - begin.y;
    ImGui::SetCursorScreenPos(begin);
    const std::string id = "###step " + std::to_string(number);
    if (ImGui::InvisibleButton(id.c_str(), {ImGui::GetContentRegionAvail().x, height}))
        session.show_construction(number);
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    ImGui::PopFont();
    ImGui::Spacing();
}

} // namespace

void construction_panel(Workspace& workspace, const CommandTable& commands, ui::ImGuiSession& gui)
{
    Session& session = workspace.session;
    for (const char* id : {"construction.back", "construction.next"}) {
        ui::command_button(workspace, commands, id);
        ImGui::SameLine();
    }
    ImGui::NewLine();
    ui::command_button(workspace, commands, "construction.whole");
    ImGui::Separator();
    if (session.is_concealing()) return;
    const auto steps = construction_of(session.document(), session.solution());
    for (std::size_t i = 0; i < steps.size(); ++i)
        step_row(session, i + 1,
                 std::to_string(i + 1) + ". " +
                     caption(steps[i].stage, session.document(), session.solution(), session.look),
                 gui);
}

} // namespace mohr
