#include "apps/frame/window/kind_question.h"

#include <imgui.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "apps/frame/session/new_commands.h"

namespace frame {

using ui::translatable;

namespace {

constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoFocusOnAppearing |
                                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove;

// A button for each kind, with its key, as wide as the sentence below.
std::optional<std::size_t> show_kinds(const Workspace& workspace, const std::string& going_on)
{
    std::optional<std::size_t> chosen;
    const float width = std::max(16.0F * ImGui::GetFontSize(), ImGui::CalcTextSize(going_on.c_str()).x);
    ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {0.0F, 0.5F});
    for (std::size_t i = 0; i < kinds().size(); ++i) {
        const bool is_it = kinds()[i].kind == workspace.session.model().analysis;
        if (is_it) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(ImGuiCol_ButtonActive));
        const std::string label = std::to_string(i + 1) + "   " + workspace.session.view.tr(kinds()[i].label);
        if (ImGui::Button((label + "###" + std::string(kinds()[i].id)).c_str(), {width, 0.0F})) chosen = i;
        if (is_it) ImGui::PopStyleColor();
    }
    ImGui::PopStyleVar();
    return chosen;
}

} // namespace

void KindQuestion::show(Workspace& workspace, const CommandTable& commands)
{
    is_open_ = is_open_ && workspace.session.is_untouched() && workspace.tool_controller.kind() == ToolKind::Select;
    if (!is_open_) return;
    const ui::Catalogue& tr = workspace.session.view.tr;
    ImGui::SetNextWindowPos(ImGui::GetMainViewport()->GetCenter(), ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::Begin((tr("New structure") + "###kind").c_str(), &is_open_, flags);
    const std::string going_on = tr("Who goes on without choosing draws a plane frame.");
    const std::optional<std::size_t> chosen = show_kinds(workspace, going_on);
    ImGui::TextDisabled("%s", going_on.c_str());
    const bool is_left = ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
                         !ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
    ImGui::End();
    if (chosen) run(*commands.find(kinds()[*chosen].id), workspace);
    if (chosen || is_left) is_open_ = false;
}

bool KindQuestion::handle_key(Workspace& workspace, const CommandTable& commands, ui::Key key)
{
    if (!std::exchange(is_open_, false)) return false;
    const auto place = static_cast<std::size_t>(key) - static_cast<std::size_t>(ui::Key::Digit1);
    const bool is_answer = key >= ui::Key::Digit1 && place < kinds().size();
    if (is_answer) run(*commands.find(kinds()[place].id), workspace);
    return is_answer || key == ui::Key::Escape || key == ui::Key::Enter;
}

} // namespace frame
