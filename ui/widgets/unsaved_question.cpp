#include "ui/widgets/unsaved_question.h"

#include <imgui.h>

#include "ui/widgets/answer_button.h"

namespace ui {

std::optional<UnsavedAnswer> ask_about_unsaved(const std::string& file_name, const Catalogue& tr)
{
    const std::string heading = tr("Unsaved changes") + "###unsaved";
    ImGui::OpenPopup("###unsaved");
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5F, 0.5F});
    if (!ImGui::BeginPopupModal(heading.c_str(), nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return std::nullopt;
    ImGui::TextUnformatted(tr("{file} has changes that are not saved.", {{"file", file_name}}).c_str());
    ImGui::Spacing();
    std::optional<UnsavedAnswer> answer;
    let_tab_choose_answer();
    if (answer_button(tr("Save") + "###save")) answer = UnsavedAnswer::Save;
    ImGui::SameLine();
    if (answer_button(tr("Do not save") + "###give up")) answer = UnsavedAnswer::GiveUp;
    ImGui::SameLine();
    const bool is_escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (answer_button(tr("Cancel") + "###cancel") || is_escaped) answer = UnsavedAnswer::Cancel;
    if (answer) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return answer;
}

} // namespace ui
