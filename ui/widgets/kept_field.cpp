#include "ui/widgets/kept_field.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <array>
#include <utility>

namespace ui {

bool do_keys_go_elsewhere()
{
    const bool types_elsewhere = ImGui::GetIO().WantTextInput &&
                                 ImGui::IsAnyItemActive(); // alone it is the last frame's
    return types_elsewhere || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
}

void settle_field() { ImGui::ClearActiveID(); }

void KeptField::offer(std::string text)
{
    text_ = std::move(text);
    is_offered_ = true;
}

// Letters and Enter that came while something else had the keyboard. \returns whether Enter did
bool KeptField::take_early_keys()
{
    ImGuiIO& io = ImGui::GetIO();
    for (const ImWchar letter : io.InputQueueCharacters) {
        constexpr ImWchar first_letter = 0x20;
        if (letter < first_letter) continue;
        if (std::exchange(is_offered_, false)) text_.clear();
        std::array<char, 5> utf8{};
        text_ += ImTextCharToUtf8(utf8.data(), letter);
    }
    io.ClearInputCharacters();
    return ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false);
}

void KeptField::place_cursor(ImGuiInputTextCallbackData& data) const
{
    data.CursorPos = data.SelectionEnd = data.BufTextLen;
    data.SelectionStart = is_offered_ ? 0 : data.BufTextLen;
}

int KeptField::on_event(ImGuiInputTextCallbackData* data)
{
    auto& field = *static_cast<KeptField*>(data->UserData);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackAlways) {
        if (!std::exchange(field.is_placed_, true)) field.place_cursor(*data);
        return 0;
    }
    field.is_offered_ = false;
    return field.edited_ != nullptr ? field.edited_(data) : 0;
}

bool KeptField::show(const char* id, const std::string& hint)
{
    const bool waits = has_keyboard_ && !is_active_ && !do_keys_go_elsewhere();
    const bool is_entered_early = waits && take_early_keys();
    constexpr int most_frames = 3; // that Dear ImGui takes; asking anew meanwhile would select what was typed
    if (waits && !ImGui::IsAnyItemActive() && n_waited_++ % most_frames == 0) {
        ImGui::SetKeyboardFocusHere();
        is_placed_ = false;
    }
    ImGui::SetNextItemWidth(-1.0F);
    constexpr ImGuiInputTextFlags flags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackEdit |
                                          ImGuiInputTextFlags_CallbackAlways;
    const bool is_entered = ImGui::InputTextWithHint(id, hint.c_str(), &text_, flags, on_event, this);
    if (is_entered_early && ImGui::IsItemActive()) ImGui::ClearActiveID(); // else it would not see another text
    const bool was_active = std::exchange(is_active_, ImGui::IsItemActive());
    if (is_active_) n_waited_ = 0;
    const bool is_given_up = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
    if (is_given_up && was_active && hold_ == Hold::UntilLeft) text_.clear(); // early letters, too
    const bool is_left = is_given_up || (text_.empty() && ((was_active && !is_active_ && !is_entered) ||
                                                           (waits && ImGui::IsMouseClicked(0))));
    has_keyboard_ = is_active_ || hold_ == Hold::UntilDone || (has_keyboard_ && !is_left);
    return is_entered || is_entered_early;
}

} // namespace ui
