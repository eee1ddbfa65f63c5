#include "ui/widgets/wrapped_field.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "ui/widgets/wrapped_text.h"

namespace ui {

namespace {

struct Wrapping {
    float width;
    bool ends_line = false; ///< Enter was pressed: the line ends there, and is not broken
};

/// Where so many letters of the text have gone by, line breaks of ours left out.
std::size_t place_after(const std::string& lines, std::size_t n_letters)
{
    std::size_t place = 0;
    for (; n_letters > 0 && place < lines.size(); ++place) {
        const bool is_ours = lines[place] == '\n' && place > 0 && lines[place - 1] == ' ';
        if (!is_ours) --n_letters;
    }
    return place;
}

void wrap_anew(ImGuiInputTextCallbackData& data, Wrapping& wrapping)
{
    std::string typed(data.Buf, static_cast<std::size_t>(data.BufTextLen));
    auto cursor = static_cast<std::size_t>(data.CursorPos);
    for (; wrapping.ends_line && cursor > 1 && typed[cursor - 2] == ' '; --cursor) typed.erase(cursor - 2, 1);
    wrapping.ends_line = false;
    const std::size_t n_before = in_one_line(typed.substr(0, cursor)).size();
    const std::string lines = in_lines(in_one_line(typed), wrapping.width);
    if (lines == std::string(data.Buf, static_cast<std::size_t>(data.BufTextLen))) return;
    data.DeleteChars(0, data.BufTextLen);
    data.InsertChars(0, lines.c_str());
    data.CursorPos = data.SelectionStart = data.SelectionEnd = static_cast<int>(place_after(lines, n_before));
}

int on_event(ImGuiInputTextCallbackData* data)
{
    Wrapping& wrapping = *static_cast<Wrapping*>(data->UserData);
    if (data->EventFlag == ImGuiInputTextFlags_CallbackCharFilter) wrapping.ends_line |= data->EventChar == '\n';
    if (data->EventFlag == ImGuiInputTextFlags_CallbackEdit) wrap_anew(*data, wrapping);
    return 0;
}

/// Blanks before a line's end would make it a break of ours.
std::string without_blanks_at_ends(const std::string& text)
{
    std::string trimmed;
    for (const char c : text) {
        while (c == '\n' && trimmed.ends_with(' ')) trimmed.pop_back();
        trimmed += c;
    }
    return trimmed;
}

} // namespace

bool WrappedField::show(const char* id, std::string& text)
{
    const ImGuiStyle& style = ImGui::GetStyle();
    const auto n_lines = [](const std::string& lines) { return 1 + static_cast<int>(std::ranges::count(lines, '\n')); };
    Wrapping wrapping{ImGui::GetContentRegionAvail().x - 2.0F * style.FramePadding.x};
    const std::string whole = without_blanks_at_ends(is_active_ ? in_one_line(typed_) : text);
    if (n_lines(in_lines(whole, wrapping.width)) > lines_.most) wrapping.width -= style.ScrollbarSize;
    if (!is_active_) typed_ = in_lines(whole, wrapping.width);
    const auto seen = static_cast<float>(std::clamp(n_lines(typed_), lines_.least, lines_.most));
    const float height = seen * ImGui::GetTextLineHeight() + 2.0F * style.FramePadding.y;
    // What we change beside it, its own undo would not find again.
    const auto flags = ImGuiInputTextFlags_CallbackEdit | ImGuiInputTextFlags_CallbackCharFilter |
                       ImGuiInputTextFlags_NoUndoRedo;
    ImGui::InputTextMultiline(id, &typed_, {-1.0F, height}, flags, on_event, &wrapping);
    const bool is_done = ImGui::IsItemDeactivatedAfterEdit();
    is_active_ = ImGui::IsItemActive();
    if (is_done) text = in_one_line(typed_);
    return is_done;
}

} // namespace ui
