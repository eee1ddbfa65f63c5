#include "ui/widgets/answer_button.h"

#include <imgui.h>

namespace ui {

// Of Dear ImGui's own a button hears the space bar alone.
bool answer_button(const std::string& label)
{
    const bool is_clicked = ImGui::Button(label.c_str());
    const bool is_chosen = ImGui::IsItemFocused() && !ImGui::GetIO().WantTextInput;
    return is_clicked || (is_chosen && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false));
}

} // namespace ui
