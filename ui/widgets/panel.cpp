#include "ui/widgets/panel.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "ui/widgets/wrapped_text.h"

namespace ui {

void begin_body(float foot)
{
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos(viewport.WorkPos);
    ImGui::SetNextWindowSize({viewport.WorkSize.x, viewport.WorkSize.y - foot});
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

void show_picture(ImVec2 size, const std::function<void()>& picture)
{
    ImGui::PushStyleColor(ImGuiCol_ChildBg, 0U);
    ImGui::BeginChild("###canvas", size);
    picture();
    ImGui::EndChild();
    ImGui::PopStyleColor();
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
                      const std::function<void()>& picture, float covered)
{
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const float em = ImGui::GetFontSize();
    const float bar = splitter_ems * em;
    const Sides shown{std::min(ems_.left * em, most_.left * room.x),
                      std::max(covered, std::min(ems_.right * em, most_.right * room.x))};
    left(shown.left);
    ImGui::SameLine();
    splitter("###left splitter", ems_.left, shown.left, 1.0F, room.y);
    ImGui::SameLine(room.x - shown.right - bar);
    splitter("###right splitter", ems_.right, shown.right, -1.0F, room.y);
    ImGui::SameLine();
    right(shown.right);
    ImGui::SameLine(shown.left + bar);
    show_picture({room.x - shown.left - shown.right - 2.0F * bar, room.y}, picture);
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

MenuRow menu_row(const std::vector<std::string>& names)
{
    constexpr float least_gap = 0.3F; // ems: on either side of a name, which it needs to be told from the next one
    float words = 0.0F;
    for (const std::string& name : names) words += ImGui::CalcTextSize(name.c_str()).x;
    const float room = ImGui::GetMainViewport()->WorkSize.x, n_gaps = 2.0F * static_cast<float>(names.size()) + 1.0F;
    const float least = words + n_gaps * least_gap * ImGui::GetFontSize();
    const float type = std::min(1.0F, room / least);
    return {std::clamp(std::floor((room - type * words) / n_gaps), 1.0F, ImGui::GetStyle().ItemSpacing.x), type};
}

void keep_next_menu_below()
{
    const float bar = ImGui::GetWindowPos().y + ImGui::GetWindowHeight();
    ImGui::SetNextWindowSizeConstraints({0.0F, 0.0F}, {FLT_MAX, ImGui::GetMainViewport()->Size.y - bar});
}

void menu_bar_title(const std::string& name)
{
    const float at = ImGui::GetWindowWidth() - ImGui::CalcTextSize(name.c_str()).x - 2.0F * ImGui::GetFontSize();
    if (at <= ImGui::GetCursorPosX()) return; // the menus come first
    ImGui::SameLine(at);
    ImGui::TextDisabled("%s", name.c_str());
}

float width_of_button(const std::string& label)
{
    return ImGui::CalcTextSize(label.c_str(), nullptr, true).x + 2.0F * ImGui::GetStyle().FramePadding.x;
}

bool TabRow::show(const std::string& title, bool is_chosen)
{
    const float end = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const float gap = 0.3F * ImGui::GetFontSize();
    if (!is_first_ && ImGui::GetItemRectMax().x + gap + width_of_button(title) <= end) ImGui::SameLine(0.0F, gap);
    is_first_ = false;
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(is_chosen ? ImGuiCol_TabActive : ImGuiCol_Tab));
    const bool is_clicked = ImGui::Button(title.c_str());
    ImGui::PopStyleColor();
    return is_clicked;
}

namespace {

float foot_padding() { return std::round(0.7F * ImGui::GetFontSize()); }
float gap_above_foot() { return std::round(0.15F * ImGui::GetFontSize()); }

// Whole pixels: Dear ImGui cuts a window's size down to them, and then scrolls what was cut off.
void begin_foot(float height, ImGuiCol background)
{
    const ImGuiViewport& viewport = *ImGui::GetMainViewport();
    ImGui::SetNextWindowPos({viewport.WorkPos.x, viewport.WorkPos.y + viewport.WorkSize.y - height});
    ImGui::SetNextWindowSize({viewport.WorkSize.x, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {foot_padding(), gap_above_foot()});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0F, 1.0F});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(background));
}

void end_foot()
{
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(3);
}

float width_of_buttons(const FootMessage& message)
{
    float width = 0.0F;
    for (const std::string& button : message.buttons) width += width_of_button(button) + 0.5F * ImGui::GetFontSize();
    return width;
}

// The words end here, so that the buttons have their room.
float room_for_words(const FootMessage& message)
{
    const float all = ImGui::GetMainViewport()->WorkSize.x - 2.0F * foot_padding();
    return std::max(all - width_of_buttons(message) - ImGui::GetFontSize(), 0.3F * all);
}

// A line that is pressed has a ground under the pointer, as entries of a list do.
bool show_link(const std::string& line, std::size_t number, float wrap_at)
{
    const ImVec2 start = ImGui::GetCursorPos();
    const float room = wrap_at - start.x;
    const float height = ImGui::CalcTextSize(in_lines(line, room).c_str(), nullptr, false, room).y;
    const bool is_pressed = ImGui::Selectable(("###link " + std::to_string(number)).c_str(), false,
                                              ImGuiSelectableFlags_None, {room, height});
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    ImGui::SetCursorPos(start);
    wrapped_text(line, wrap_at);
    return is_pressed;
}

// Which link is pressed, counted on after the buttons.
std::optional<std::size_t> show_lines(const FootMessage& message, float wrap_at)
{
    std::optional<std::size_t> pressed;
    for (std::size_t i = 0; i < message.lines.size(); ++i) {
        const auto link = std::ranges::find(message.links, i);
        if (link == message.links.end()) wrapped_text(message.lines[i], wrap_at);
        else if (show_link(message.lines[i], i, wrap_at))
            pressed = message.buttons.size() + static_cast<std::size_t>(link - message.links.begin());
    }
    return pressed;
}

} // namespace

float status_height() { return ImGui::GetFrameHeight(); }

void begin_status_bar()
{
    constexpr int first_frames = 2; // in which one window after the other appears, and the last has the focus
    const bool is_back = ImGui::GetFrameCount() > first_frames; // after a notice: menus and fields stay open
    begin_foot(status_height(), ImGuiCol_MenuBarBg);
    ImGui::Begin("###status", nullptr,
                 fixed_panel | ImGuiWindowFlags_NoScrollbar |
                     (is_back ? ImGuiWindowFlags_NoFocusOnAppearing : ImGuiWindowFlags_None));
}

void end_status_bar() { end_foot(); }

float height(const FootMessage& message)
{
    const float room = room_for_words(message);
    float words = 0.0F;
    for (const std::string& line : message.lines)
        words += ImGui::CalcTextSize(in_lines(line, room).c_str(), nullptr, false, room).y;
    const float gaps = std::max(status_height() - ImGui::GetTextLineHeight(), 2.0F * gap_above_foot());
    const float most = 0.4F * ImGui::GetMainViewport()->WorkSize.y; // what is longer is scrolled
    return std::ceil(std::clamp(words + gaps, status_height(), std::max(status_height(), most)));
}

std::optional<std::size_t> show(const FootMessage& message)
{
    begin_foot(height(message), ImGuiCol_TabActive); // it is to be seen that something is told
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0.5F * ImGui::GetFontSize(), 0.0F});
    ImGui::Begin("###message", nullptr, fixed_panel | ImGuiWindowFlags_NoFocusOnAppearing);
    const ImVec2 corner = ImGui::GetCursorPos();
    const float room = room_for_words(message);
    std::optional<std::size_t> pressed = show_lines(message, corner.x + room);
    ImGui::SetCursorPos({ImGui::GetMainViewport()->WorkSize.x - foot_padding() - width_of_buttons(message), corner.y});
    for (std::size_t i = 0; i < message.buttons.size(); ++i) {
        if (ImGui::SmallButton(message.buttons[i].c_str())) pressed = i;
        ImGui::SameLine();
    }
    ImGui::PopStyleVar();
    end_foot();
    return pressed;
}

} // namespace ui
