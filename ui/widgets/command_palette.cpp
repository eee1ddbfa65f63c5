#include <imgui.h>
#include <imgui_stdlib.h>

#include "ui/widgets/command_menu.h"
#include "ui/widgets/item_label.h"

namespace ui {

void CommandPalette::open()
{
    is_open_ = is_fresh_ = true;
    typed_.clear();
    chosen_ = 0;
}

bool CommandPalette::begin(const Catalogue& tr, std::size_t n_found)
{
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    const float width = std::min(0.9F * viewport.WorkSize.x, 40.0F * ImGui::GetFontSize()); // name and keys of a line
    const ImVec2 top(viewport.WorkPos.x + 0.5F * viewport.WorkSize.x, viewport.WorkPos.y + 0.1F * viewport.WorkSize.y);
    ImGui::SetNextWindowPos(top, ImGuiCond_Always, {0.5F, 0.0F});
    ImGui::SetNextWindowSize({width, 0.0F});
    if (is_fresh_) ImGui::SetNextWindowFocus();
    // The arrows choose a line, and leave the keyboard in the field.
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_NoNavInputs;
    ImGui::Begin("###palette", nullptr, flags);

    const auto is_pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
    if (is_pressed(ImGuiKey_Escape)) is_open_ = false;
    if (is_pressed(ImGuiKey_DownArrow) && chosen_ + 1 < n_found) ++chosen_;
    if (is_pressed(ImGuiKey_UpArrow) && chosen_ > 0) --chosen_;
    if (chosen_ >= n_found) chosen_ = 0;

    ImGui::SetNextItemWidth(-1.0F);
    const bool ran_nothing = is_confirmed_; // Enter, which takes the keyboard from the field
    if (is_fresh_ || ran_nothing) ImGui::SetKeyboardFocusHere();
    is_confirmed_ = ImGui::InputTextWithHint("###typed", tr("Type what you want to do").c_str(), &typed_,
                                             ImGuiInputTextFlags_EnterReturnsTrue);
    const bool is_list_focused = !is_fresh_ && !ImGui::IsItemActive() &&
                                 ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
    is_confirmed_ |= is_list_focused && (is_pressed(ImGuiKey_Enter) || is_pressed(ImGuiKey_KeyPadEnter));
    const bool has_lost_focus = !is_fresh_ && !ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows);
    if (has_lost_focus) is_open_ = false;
    is_fresh_ = false;
    why_not_chosen_.clear();
    return ImGui::BeginChild("###found", {0.0F, 14.0F * ImGui::GetTextLineHeightWithSpacing()}, false,
                             ImGuiWindowFlags_NoNavInputs);
}

bool CommandPalette::show_line(std::size_t place, const Line& line)
{
    const bool is_chosen = place == chosen_;
    const bool can_run = line.why_not.empty();
    const ImGuiSelectableFlags flags = can_run ? ImGuiSelectableFlags_None : ImGuiSelectableFlags_Disabled;
    const bool is_clicked = ImGui::Selectable(shown_whole(line.name).c_str(), is_chosen, flags);
    if (!can_run && ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) show_tooltip(line.why_not);
    if (is_chosen) why_not_chosen_ = line.why_not;
    if (is_chosen && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
    if (!line.keys.empty()) {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::CalcTextSize(line.keys.c_str()).x);
        ImGui::TextDisabled("%s", line.keys.c_str());
    }
    return can_run && (is_clicked || (is_chosen && is_confirmed_));
}

void CommandPalette::end()
{
    ImGui::EndChild();
    if (!why_not_chosen_.empty()) wrapped_text(why_not_chosen_);
    ImGui::End();
}

} // namespace ui
