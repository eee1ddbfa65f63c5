#include "ui/widgets/number_field.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "ui/widgets/wrapped_text.h"

namespace ui {

namespace {

constexpr double pixels_per_step = 3.0;
constexpr float click_distance = 3.0F; ///< the mouse moved farther: a drag

float width_of(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x; }

/// The text, or as much of its beginning as there is room for with the mark of what is missing.
std::string fitting(const std::string& text, float room)
{
    if (width_of(text) <= room) return text;
    const float left = room - width_of("…");
    std::size_t n = text.size();
    const auto is_inside_character = [&] { return (static_cast<unsigned char>(text[n]) & 0xC0U) == 0x80U; };
    do --n;
    while (n > 0 && (is_inside_character() || width_of(std::string_view(text).substr(0, n)) > left));
    return text.substr(0, n) + "…";
}

unsigned key_of(std::string_view id) { return ImGui::GetID(id.data(), id.data() + id.size()); }

} // namespace

double drag_step(double value)
{
    const double size = std::abs(value);
    if (!(size > 0.0) || !std::isfinite(size)) return 0.1;
    const double decade = std::pow(10.0, std::floor(std::log10(size)) - 1.0);
    return size / decade >= 50.0 ? decade : 0.5 * decade;
}

bool NumberFields::is_typing() const { return typing_ != 0 && ImGui::GetFrameCount() <= last_shown_ + 1; }

NumberFieldEvent NumberFields::show(std::string_view id, const Look& look)
{
    const unsigned key = key_of(id);
    const float width = look.width > 0.0F ? look.width : ImGui::GetContentRegionAvail().x;
    ImGui::PushID(static_cast<int>(key));
    if (!is_typing()) typing_ = 0;
    const bool arrives = stops_.arrives(key);
    if (typing_ == 0 && (look.begins || arrives)) open_editor(key, look.exact_text);
    if (typing_ == key) stops_.stand(key);
    NumberFieldEvent event = typing_ == key ? show_editor(key, look, width) : show_value(key, look, width);
    if (left_ && left_->id == key) event = typed(key, std::exchange(left_, std::nullopt)->text);
    ImGui::PopID();
    return event;
}

NumberFieldEvent NumberFields::show_value(unsigned id, const Look& look, float width)
{
    const ImGuiStyle& style = ImGui::GetStyle();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size(width, ImGui::GetFrameHeight());
    ImGui::InvisibleButton("value", size);
    const bool is_hot = ImGui::IsItemHovered() || ImGui::IsItemActive();
    if (is_hot) ImGui::SetMouseCursor(look.is_typed_only ? ImGuiMouseCursor_TextInput : ImGuiMouseCursor_ResizeEW);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 end(corner.x + size.x, corner.y + size.y);
    list.AddRectFilled(corner, end, ImGui::GetColorU32(is_hot ? ImGuiCol_FrameBgHovered : ImGuiCol_FrameBg),
                       style.FrameRounding);
    const ImVec2 text_at(corner.x + style.FramePadding.x, corner.y + style.FramePadding.y);
    const std::string text = fitting(look.text, width - 2.0F * style.FramePadding.x);
    list.PushClipRect(corner, end, true);
    const bool is_given = look.is_typed_only || look.value;
    list.AddText(text_at, ImGui::GetColorU32(is_given ? ImGuiCol_Text : ImGuiCol_TextDisabled), text.c_str());
    list.PopClipRect();
    if (is_hot && text != look.text) ImGui::SetTooltip("%s", look.text.c_str());

    if (dragging_ == id) {
        const NumberFieldEvent event = drag(drag_start_);
        if (event.kind != NumberFieldEvent::Kind::None || dragging_ == id) return event;
    }
    if (!look.is_typed_only && ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left, click_distance)) {
        dragging_ = id;
        drag_start_ = drag_value_ = look.value.value_or(0.0);
        drag_path_ = 0.0;
        return drag(drag_start_);
    }
    if (ImGui::IsItemDeactivated() && ImGui::IsItemHovered()) open_editor(id, look.exact_text);
    return {};
}

void NumberFields::open_editor(unsigned id, std::string text)
{
    if (is_typing() && stays_ && typing_ != id && text_ != opening_text_) left_ = Left{typing_, text_};
    keyboard_.forget();
    typing_ = id;
    ++n_openings_;
    last_shown_ = ImGui::GetFrameCount();
    is_open_ = false;
    text_ = opening_text_ = std::move(text);
    reason_.clear();
}

void NumberFields::open(std::string_view id, std::string text) { open_editor(key_of(id), std::move(text)); }

bool NumberFields::is_open(std::string_view id) const { return is_typing() && typing_ == key_of(id); }

bool NumberFields::is_entered(std::string_view id) const
{
    return entered_ == key_of(id) && frame_entered_ == ImGui::GetFrameCount();
}

NumberFieldEvent NumberFields::drag(double start)
{
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        dragging_ = 0;
        return {.kind = NumberFieldEvent::Kind::Settled, .value = drag_value_};
    }
    const double slow = ImGui::GetIO().KeyShift ? 0.1 : 1.0;
    drag_path_ += slow * static_cast<double>(ImGui::GetIO().MouseDelta.x);
    const double step = drag_step(start);
    const double fine = ImGui::GetIO().KeyShift ? 0.1 * step : step;
    // Rounded to the step, so that the values passed through are ones that a person would type.
    const double value = std::round((start + step * drag_path_ / pixels_per_step) / fine) * fine;
    const double tidy = std::abs(value) < 1e-9 * step ? 0.0 : value;
    if (tidy == drag_value_) return {};
    drag_value_ = tidy;
    return {.kind = NumberFieldEvent::Kind::Dragged, .value = tidy};
}

// A row has no room beneath it; the window of the reason stays on the screen.
void NumberFields::show_reason(bool is_in_row) const
{
    if (!is_in_row) return wrapped_text(reason_);
    const float em = ImGui::GetFontSize();
    const float most = 25.0F * em, padding = ImGui::GetStyle().WindowPadding.x;
    const float width = std::min(ImGui::CalcTextSize(reason_.c_str()).x, most) + 2.0F * padding;
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    const float right = screen.WorkPos.x + screen.WorkSize.x - width;
    const float left = std::max(std::min(ImGui::GetItemRectMin().x, right), screen.WorkPos.x);
    const float height = ImGui::CalcTextSize(reason_.c_str(), nullptr, false, most).y + 2.0F * padding;
    const float below = ImGui::GetItemRectMax().y + 0.3F * em, above = ImGui::GetItemRectMin().y - 0.3F * em - height;
    const bool has_room_below = below + height <= screen.WorkPos.y + screen.WorkSize.y;
    ImGui::SetNextWindowPos({left, has_room_below ? below : above});
    ImGui::BeginTooltip();
    wrapped_text(reason_, most);
    ImGui::EndTooltip();
}

NumberFieldEvent NumberFields::typed(unsigned id, std::string text)
{
    last_typed_ = id;
    return {.kind = NumberFieldEvent::Kind::Typed, .text = std::move(text)};
}

NumberFieldEvent NumberFields::show_editor(unsigned id, const Look& look, float width)
{
    stays_ = look.stays;
    last_shown_ = ImGui::GetFrameCount();
    ImGui::SetNextItemWidth(width);
    if (!std::exchange(is_open_, true)) ImGui::SetKeyboardFocusHere();
    keyboard_.before_field();
    const bool has_reason = !reason_.empty();
    if (has_reason) ImGui::PushStyleColor(ImGuiCol_FrameBg, ImVec4(0.85F, 0.25F, 0.15F, 0.25F));
    ImGui::PushID(n_openings_); // an editor of its own: Dear ImGui would undo what was typed into the one before
    ImGui::PushAllowKeyboardFocus(false); // Tab is ours: the other fields are none to Dear ImGui until they are opened
    constexpr ImGuiInputTextFlags flags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll |
                                          ImGuiInputTextFlags_CallbackAlways;
    const bool is_confirmed = ImGui::InputText("###text", &text_, flags, KeyboardBack::place_cursor, &keyboard_);
    keyboard_.after_field();
    ImGui::PopAllowKeyboardFocus();
    ImGui::PopID();
    if (has_reason) ImGui::PopStyleColor();
    const bool is_left = ImGui::IsItemDeactivated();
    const bool is_tab = ImGui::IsItemActive() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab));
    const bool is_cancelled = is_left && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape));
    if (has_reason) show_reason(look.width > 0.0F);
    if (!is_confirmed && !is_left && !is_tab) return {};
    const bool is_half_typed = !is_confirmed && !is_tab && !is_cancelled && text_ != opening_text_;
    if (stays_ && is_half_typed) {
        keyboard_.lose();
        return {};
    }

    typing_ = 0;
    if (is_tab) stops_.leave(id);
    reason_.clear();
    if (is_confirmed) {
        entered_ = id;
        frame_entered_ = ImGui::GetFrameCount();
    }
    if (is_cancelled || text_ == opening_text_) return {};
    return typed(id, text_);
}

void NumberFields::reject(const NumberFieldEvent& event, std::string reason)
{
    typing_ = last_typed_;
    keyboard_.forget();
    stops_.stay();
    entered_ = 0;
    ++n_openings_;
    is_open_ = false;
    text_ = event.text;
    reason_ = std::move(reason);
}

} // namespace ui
