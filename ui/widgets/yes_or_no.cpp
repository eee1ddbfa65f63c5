#include "ui/widgets/yes_or_no.h"

#include <imgui.h>

#include "ui/widgets/answer_button.h"

namespace ui {

std::optional<bool> ask_yes_or_no(const YesOrNo& question)
{
    ImGui::OpenPopup("###yes or no");
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5F, 0.5F});
    if (!ImGui::BeginPopupModal((question.heading + "###yes or no").c_str(), nullptr,
                                ImGuiWindowFlags_AlwaysAutoResize))
        return std::nullopt;
    ImGui::TextUnformatted(question.sentence.c_str());
    ImGui::Spacing();
    std::optional<bool> answer;
    let_tab_choose_answer();
    const bool is_escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (answer_button(question.no + "###no") || is_escaped) answer = false;
    ImGui::SameLine();
    if (answer_button(question.yes + "###yes")) answer = true;
    if (answer) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return answer;
}

} // namespace ui
