#include "ui/widgets/side_window.h"

#include <imgui.h>

#include <algorithm>
#include <utility>

#include "ui/widgets/answer_button.h"
#include "ui/widgets/modal_turn.h"

namespace ui {

bool SideWindow::begin(bool is_open, const char* id, const std::string& title, TabStops& stops)
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
    if (!ImGui::BeginPopupModal((title + id).c_str(), nullptr, flags)) return false;
    stops.begin_window();
    return true;
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

void SideWindow::end(bool is_open, TabStops& stops)
{
    stops.end_window();
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

namespace {

/// Whether a list was open over the window in the frame before: then keys are the list's, which has closed by now.
bool had_list()
{
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const ImGuiID id = ImGui::GetID("###list over it");
    const bool had = kept.GetBool(id);
    kept.SetBool(id, ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId));
    return had;
}

} // namespace

// Enter accepts wherever Tab has come to, but at the other button.
FootAnswer foot_buttons(const FootButtons& buttons, const Catalogue& tr, TabStops& stops)
{
    const bool has_keys = !had_list() && !buttons.is_typing && !ImGui::GetIO().WantTextInput;
    const auto is_pressed = [&](int key) { return has_keys && ImGui::IsKeyPressed(ImGui::GetKeyIndex(key), false); };
    ImGui::BeginDisabled(!buttons.may_accept);
    const bool is_clicked = ImGui::Button(buttons.accept.c_str());
    stops.add();
    ImGui::EndDisabled();
    ImGui::SameLine();
    const bool is_cancelled = answer_button(tr("Cancel") + "###cancel") || is_pressed(ImGuiKey_Escape);
    stops.add();
    if (is_cancelled) return FootAnswer::Cancel;
    const bool is_entered = buttons.may_accept && is_pressed(ImGuiKey_Enter);
    return is_clicked || is_entered ? FootAnswer::Accept : FootAnswer::None;
}

} // namespace ui
