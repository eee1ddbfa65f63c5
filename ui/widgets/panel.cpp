#include "ui/widgets/panel.h"

#include <algorithm>
#include <cmath>

#include "ui/widgets/wrapped_text.h"

namespace ui {

void begin_body()
{
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    const float status = ImGui::GetFrameHeight();
    ImGui::SetNextWindowPos(viewport.WorkPos);
    ImGui::SetNextWindowSize({viewport.WorkSize.x, viewport.WorkSize.y - status});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0F, 0.0F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.0F, 0.0F});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, 0U);
    ImGui::Begin("###body", nullptr, fixed_panel);
}

void end_body()
{
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(4);
}

void begin_panel(const char* id, float width)
{
    const float em = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.7F * em, 0.5F * em});
    ImGui::BeginChild(id, {width, 0.0F}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.6F * em, 0.35F * em});
}

void end_panel()
{
    ImGui::PopStyleVar();
    ImGui::EndChild();
    ImGui::PopStyleVar();
}

namespace {

// A bar beside a panel, dragged to give it another width [ems]; `sign` is 1 where the panel is at its left, else -1.
void splitter(const char* id, float& width, float shown, float sign, float height)
{
    const float em = ImGui::GetFontSize();
    ImGui::InvisibleButton(id, {splitter_ems * em, height});
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActive()) width = std::clamp(shown / em + sign * ImGui::GetIO().MouseDelta.x / em, 8.0F, 40.0F);
}

} // namespace

void SidePanels::show(const std::function<void(float)>& left, const std::function<void(float)>& right,
                      const std::function<void()>& picture)
{
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float em = ImGui::GetFontSize();
    const float bar = splitter_ems * em;
    const Sides shown{std::min(ems_.left * em, most_.left * room.x), std::min(ems_.right * em, most_.right * room.x)};
    left(shown.left);
    ImGui::SameLine();
    splitter("###left splitter", ems_.left, shown.left, 1.0F, room.y);
    ImGui::SameLine(room.x - shown.right - bar);
    splitter("###right splitter", ems_.right, shown.right, -1.0F, room.y);
    ImGui::SameLine();
    right(shown.right);
    ImGui::SameLine(shown.left + bar);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, 0U);
    ImGui::BeginChild("###canvas", {room.x - shown.left - shown.right - 2.0F * bar, room.y});
    picture();
    ImGui::EndChild();
    ImGui::PopStyleColor();
}

void show_below(float height, const std::function<void()>& content)
{
    const ImVec2 corner = ImGui::GetCursorPos();
    ImGui::SetCursorPos({corner.x, corner.y + ImGui::GetContentRegionAvail().y - height});
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImGui::GetStyleColorVec4(ImGuiCol_MenuBarBg));
    ImGui::BeginChild("###below", {0.0F, height});
    content();
    ImGui::EndChild();
    ImGui::PopStyleColor();
    ImGui::SetCursorPos(corner);
}

void menu_bar_title(const std::string& name)
{
    const float at = ImGui::GetWindowWidth() - ImGui::CalcTextSize(name.c_str()).x - 2.0F * ImGui::GetFontSize();
    if (at <= ImGui::GetCursorPosX()) return; // the menus come first
    ImGui::SameLine(at);
    ImGui::TextDisabled("%s", name.c_str());
}

bool TabRow::show(const std::string& title, bool is_chosen)
{
    const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const float gap = 0.3F * ImGui::GetFontSize();
    const float words = ImGui::CalcTextSize(title.c_str(), nullptr, true).x;
    const float width = words + 2.0F * ImGui::GetStyle().FramePadding.x;
    if (!is_first_ && ImGui::GetItemRectMax().x + gap + width <= end) ImGui::SameLine(0.0F, gap);
    is_first_ = false;
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(is_chosen ? ImGuiCol_TabActive : ImGuiCol_Tab));
    const bool is_clicked = ImGui::Button(title.c_str());
    ImGui::PopStyleColor();
    return is_clicked;
}

void begin_status_bar()
{
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    const float height = ImGui::GetFrameHeight();
    ImGui::SetNextWindowPos({viewport.WorkPos.x, viewport.WorkPos.y + viewport.WorkSize.y - height});
    ImGui::SetNextWindowSize({viewport.WorkSize.x, height});
    const float em = ImGui::GetFontSize();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.7F * em, 0.15F * em});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0F, 1.0F});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_MenuBarBg));
    ImGui::Begin("###status", nullptr, fixed_panel | ImGuiWindowFlags_NoScrollbar);
}

void end_status_bar()
{
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(3);
}

std::optional<std::size_t> begin_message_box(const std::vector<std::string>& lines)
{
    const float em = ImGui::GetFontSize();
    const ImVec2 corner = ImGui::GetWindowPos();
    const float width = ImGui::GetWindowWidth();
    ImGui::SetNextWindowPos({corner.x + em, corner.y + em});
    ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {width - 2.0F * em, 20.0F * em});
    // Whole pixels: Dear ImGui cuts a window's size down to them, and then scrolls what was cut off.
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {std::round(em), std::round(0.7F * em)});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.6F * em, 0.35F * em});
    constexpr ImGuiWindowFlags flags = fixed_panel | ImGuiWindowFlags_AlwaysAutoResize |
                                       ImGuiWindowFlags_NoFocusOnAppearing;
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg)); // the canvas has none
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0F);
    ImGui::Begin("###banner", nullptr, flags & ~ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    std::optional<std::size_t> clicked;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        wrapped_text(lines[i], width - 4.0F * em);
        if (ImGui::IsItemClicked()) clicked = i;
    }
    return clicked;
}

void end_message_box()
{
    ImGui::End();
    ImGui::PopStyleVar(2);
}

} // namespace ui
