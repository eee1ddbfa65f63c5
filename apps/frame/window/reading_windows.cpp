#include "apps/frame/window/reading_windows.h"

#include <imgui.h>

#include <string>

#include "apps/frame/window/no_results.h"
#include "ui/widgets/shortcut_sheet.h"
#include "ui/widgets/wrapped_text.h"

namespace frame {

void description_window(Desk& desk, bool& is_open)
{
    if (!is_open) return;
    const ui::Catalogue& tr = desk.session.view.tr;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({46.0F * em, 32.0F * em}, ImGuiCond_Appearing);
    ImGui::Begin((tr("Model and results in words") + "###description").c_str(), &is_open,
                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse);
    const std::string words = desk.session.in_words();
    if (ImGui::Button((tr("Copy") + "###copy").c_str())) ImGui::SetClipboardText(words.c_str());
    if (desk.session.hidden) ImGui::SameLine();
    offer_to_reveal(desk);
    ImGui::BeginChild("words");
    ui::wrapped_text(words);
    ImGui::EndChild();
    ImGui::End();
}

void shortcut_window(const Desk& desk, const CommandTable& commands, bool& is_open)
{
    if (is_open) ui::shortcut_sheet(ui::key_lines(commands, desk, desk.session.view.tr), desk.session.view.tr, is_open);
}

} // namespace frame
