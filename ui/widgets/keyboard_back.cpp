#include "ui/widgets/keyboard_back.h"

#include <imgui.h>

#include <utility>

namespace ui {

void KeyboardBack::before_field()
{
    const bool is_elsewhere = ImGui::IsAnyItemActive() || ImGui::IsAnyMouseDown() ||
                              ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    constexpr int most_frames = 3; // that Dear ImGui takes
    if (!is_lost_ || is_elsewhere || n_waited_++ % most_frames != 0) return;
    ImGui::SetKeyboardFocusHere();
    is_placed_ = false;
}

void KeyboardBack::after_field()
{
    if (!is_lost_ || !ImGui::IsItemActive()) return;
    is_lost_ = false;
    n_waited_ = 0;
}

int KeyboardBack::place_cursor(ImGuiInputTextCallbackData* data)
{
    auto& keyboard = *static_cast<KeyboardBack*>(data->UserData);
    if (!std::exchange(keyboard.is_placed_, true))
        data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
    return 0;
}

} // namespace ui
