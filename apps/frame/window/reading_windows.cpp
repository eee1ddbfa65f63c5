#include "apps/frame/window/reading_windows.h"

#include <imgui.h>

#include <string>

#include "femoop/result/describe.h"

namespace frame {

void description_window(const Session& session, bool& is_open)
{
    if (!is_open) return;
    const ui::Catalogue& tr = session.view.tr;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({46.0F * em, 32.0F * em}, ImGuiCond_Appearing);
    ImGui::Begin((tr("Model and results in words") + "###description").c_str(), &is_open,
                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse);
    const std::string words = femoop::describe(session.model(), session.solution().results, tr);
    if (ImGui::Button((tr("Copy") + "###copy").c_str())) ImGui::SetClipboardText(words.c_str());
    ImGui::BeginChild("words");
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(words.c_str());
    ImGui::PopTextWrapPos();
    ImGui::EndChild();
    ImGui::End();
}

void shortcut_window(const Desk& desk, const CommandTable& commands, bool& is_open)
{
    if (!is_open) return;
    const ui::Catalogue& tr = desk.session.view.tr;
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Appearing, {0.5F, 0.5F});
    ImGui::Begin((tr("Keys") + "###shortcuts").c_str(), &is_open,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse);
    if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) {
        for (const auto& command : commands.all()) {
            if (command.shortcuts.empty()) continue;
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(text(command.shortcuts.front()).c_str());
            ImGui::TableNextColumn();
            const std::string menu = command.menu.empty() ? "" : tr(command.menu) + "  ›  ";
            ImGui::TextUnformatted((menu + ui::label(command, desk, tr)).c_str());
        }
        ImGui::EndTable();
    }
    ImGui::End();
}

} // namespace frame
