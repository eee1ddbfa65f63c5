#include "apps/cross/window/value_field.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>

#include "apps/cross/window/field_reason.h"

namespace cross {

namespace {

constexpr float ems_wide = 9.0F;

} // namespace

void ValueField::open(const Session& session, const TypedValue& value, ui::Point at)
{
    value_ = value;
    at_ = at;
    text_ = opening_ = text_of(session, value);
    reason_.clear();
    n_solved_ = session.n_solved();
    ++n_openings_;
    is_fresh_ = true;
}

void ValueField::show(Session& session, ui::Point corner, float scale)
{
    if (value_ && n_solved_ != session.n_solved()) value_.reset(); // it may be gone
    if (!value_) return;
    const ui::Point at = corner + at_;
    const float width = ems_wide * ImGui::GetFontSize();
    const float left = static_cast<float>(corner.x) * scale;
    const float last = std::max(left, ImGui::GetWindowPos().x + ImGui::GetWindowWidth() - width);
    // A field beyond the picture's end would make Dear ImGui scroll it.
    ImGui::SetCursorScreenPos({std::clamp(static_cast<float>(at.x) * scale - 0.5F * width, left, last),
                               static_cast<float>(at.y) * scale - 0.5F * ImGui::GetFrameHeight()});
    ImGui::SetNextItemWidth(width);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1.0F);
    edit(session);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    const auto factor = static_cast<double>(scale);
    if (value_ && !reason_.empty()) show_reason(reason_, factor * at, factor * corner.x);
}

void ValueField::edit(Session& session)
{
    if (is_fresh_) ImGui::SetKeyboardFocusHere();
    ImGui::PushID(n_openings_); // an editor of its own for each value
    const bool is_entered = ImGui::InputText("###value", &text_,
                                             ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    ImGui::PopID();
    is_fresh_ = is_fresh_ && !ImGui::IsItemActive(); // it takes a frame or two to get the keyboard
    const bool is_left = ImGui::IsItemDeactivated();
    const bool is_tabbed = ImGui::IsItemActive() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Tab));
    if (is_left && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) return value_.reset();
    if (is_entered || is_tabbed || is_left) confirm(session);
}

void ValueField::confirm(Session& session)
{
    if (text_ == opening_) return value_.reset();
    auto next = with_value(session, *value_, text_);
    if (auto* const model = std::get_if<femoop::Model>(&next)) {
        value_.reset();
        return session.change(std::move(*model), ui::translatable("Type a value"));
    }
    reason_ = session.tr()(std::get<ui::Message>(next));
    ++n_openings_;
    is_fresh_ = true;
}

} // namespace cross
