#include "ui/widgets/text_window.h"

#include <imgui.h>

#include "ui/widgets/wrapped_text.h"

namespace ui {

void text_window(const std::string& title, const std::string& words, const Catalogue& tr, bool& is_open,
                 const std::function<void()>& beside_copy)
{
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({46.0F * em, 32.0F * em}, ImGuiCond_Appearing);
    ImGui::Begin((title + "###description").c_str(), &is_open,
                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse);
    if (ImGui::Button((tr("Copy") + "###copy").c_str())) ImGui::SetClipboardText(words.c_str());
    if (beside_copy) beside_copy();
    ImGui::BeginChild("words");
    wrapped_text(words);
    ImGui::EndChild();
    ImGui::End();
}

} // namespace ui
