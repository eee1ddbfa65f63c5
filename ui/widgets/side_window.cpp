#include "ui/widgets/side_window.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "ui/widgets/modal_turn.h"

namespace ui {

bool SideWindow::begin(bool is_open, const char* id, const std::string& title)
{
    light_up(is_open);
    if (!is_open) return false;
    if (!has_turn(id)) return false;
    if (!ImGui::IsPopupOpen(id)) ImGui::OpenPopup(id);
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    const float status = ImGui::GetFrameHeight();
    ImGui::SetNextWindowPos({viewport.WorkPos.x + viewport.WorkSize.x - width(), viewport.WorkPos.y});
    ImGui::SetNextWindowSize({width(), viewport.WorkSize.y - status});
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoCollapse;
    return ImGui::BeginPopupModal((title + id).c_str(), nullptr, flags);
}

void SideWindow::begin_content()
{
    const float foot = ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
    ImGui::BeginChild("###content", {0.0F, -foot});
}

void SideWindow::end_content()
{
    ImGui::EndChild();
    ImGui::Separator();
}

void SideWindow::end(bool is_open)
{
    if (!is_open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

float SideWindow::width()
{
    return std::min(24.0F * ImGui::GetFontSize(), 0.3F * ImGui::GetMainViewport()->WorkSize.x);
}

// Dear ImGui dims at the frame's end, out of a pushed colour's reach; a new theme brings the dimming back.
void SideWindow::light_up(bool is_open)
{
    float& dimming = ImGui::GetStyle().Colors[ImGuiCol_ModalWindowDimBg].w;
    if (is_open && dimming > 0.0F) dimming_ = std::exchange(dimming, 0.0F);
    if (!is_open && dimming_) dimming = *std::exchange(dimming_, std::nullopt);
}

FootAnswer foot_buttons(const FootButtons& buttons, const Catalogue& tr)
{
    const bool has_keys = !buttons.is_typing && !ImGui::GetIO().WantTextInput;
    const auto is_pressed = [&](int key) { return has_keys && ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); };
    ImGui::BeginDisabled(!buttons.may_accept);
    const bool is_clicked = ImGui::Button(buttons.accept.c_str());
    ImGui::EndDisabled();
    ImGui::SameLine();
    const bool is_cancelled = ImGui::Button((tr("Cancel") + "###cancel").c_str()) || is_pressed(ImGuiKey_Escape);
    if (is_clicked || (buttons.may_accept && is_pressed(ImGuiKey_Enter))) return FootAnswer::Accept;
    return is_cancelled ? FootAnswer::Cancel : FootAnswer::None;
}

} // namespace ui
