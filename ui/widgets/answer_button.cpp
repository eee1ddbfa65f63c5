#include "ui/widgets/answer_button.h"

#include <imgui.h>
#include <imgui_internal.h>

namespace ui {

// Of Dear ImGui's own a button hears the space bar alone.
bool answer_button(const std::string& label)
{
    const bool is_clicked = ImGui::Button(label.c_str());
    const bool is_chosen = ImGui::IsItemFocused() && !ImGui::GetIO().WantTextInput;
    return is_clicked || (is_chosen && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false));
}

void let_tab_choose_answer()
{
    if (ImGui::IsWindowAppearing()) ImGui::GetCurrentContext()->NavDisableHighlight = false;
    if (!ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab))) return;
    const ImGuiDir way = ImGui::GetIO().KeyShift ? ImGuiDir_Left : ImGuiDir_Right;
    ImGui::NavMoveRequestSubmit(way, way, ImGuiNavMoveFlags_None, ImGuiScrollFlags_None);
}

} // namespace ui
