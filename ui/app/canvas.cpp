#include "ui/app/canvas.h"

#include <algorithm>
#include <array>
#include <utility>

#include "ui/canvas/click.h"
#include "ui/paint/wrapped_lines.h"

namespace ui {

namespace {

Point logical(ImVec2 v, float pixels) { return {static_cast<double>(v.x / pixels), static_cast<double>(v.y / pixels)}; }

} // namespace

bool Canvas::begin(const ImGuiSession& gui, ImGuiButtonFlags buttons)
{
    constexpr float least = 8.0F;
    corner_pixel_ = ImGui::GetCursorScreenPos();
    room_ = ImGui::GetContentRegionAvail();
    if (room_.x < least || room_.y < least) return false;
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    const auto pixels = static_cast<float>(gui.scale());
    corner_ = logical(corner_pixel_, pixels);
    pointer_ = logical({pointer.x - corner_pixel_.x, pointer.y - corner_pixel_.y}, pixels);
    const Point size = logical(room_, pixels);
    sheet_ = {size.x, size.y};
    ImGui::InvisibleButton("canvas", room_, buttons);
    is_over_ = ImGui::IsItemHovered();
    is_active_ = ImGui::IsItemActive();
    is_pressed_ = ImGui::IsItemActivated() && ImGui::IsMouseDown(ImGuiMouseButton_Left);
    is_released_ = ImGui::IsItemDeactivated();
    if (is_pressed_) pressed_at_ = pointer_;
    is_dragged_ = !is_pressed_ && (is_dragged_ || distance(pointer_, pressed_at_) > click_reach);
    return true;
}

void Canvas::end(ImGuiSession& gui) const
{
    const ImVec2 &a = corner_pixel_, b{a.x + room_.x, a.y + room_.y};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(a, b, true);
    gui.show(*picture_, list, {static_cast<double>(a.x), static_cast<double>(a.y)});
    list.PopClipRect();
}

ViewMove Canvas::view_move(ViewButtons buttons)
{
    ViewMove move{.wheel = static_cast<double>(ImGui::GetIO().MouseWheel)};
    const std::array<std::pair<ImGuiMouseButton, bool>, 3> all{{{ImGuiMouseButton_Left, buttons.left},
                                                                {ImGuiMouseButton_Middle, buttons.middle},
                                                                {ImGuiMouseButton_Right, buttons.right}}};
    const bool is_held = std::ranges::any_of(
        all, [](const auto& button) { return button.second && ImGui::IsMouseDown(button.first); });
    if (!is_held) {
        // The release of a drag is seen in the frame in which nothing is held any more.
        if (!ImGui::IsMouseReleased(ImGuiMouseButton_Left)) is_moving_view_ = false;
        hold_.reset();
        return move;
    }
    const Point at = corner_ + pointer_;
    if (!hold_) hold_ = at;
    is_moving_view_ = is_moving_view_ || buttons.move_at_once || distance(at, *hold_) > click_reach;
    if (!is_moving_view_) return move;
    move.drag = at - *std::exchange(hold_, at);
    move.is_left = buttons.left && ImGui::IsMouseDown(ImGuiMouseButton_Left);
    return move;
}

void draw_invitation(Painter& painter, const Theme& theme, const std::vector<std::string>& lines)
{
    TextStyle style = theme.text(Role::FaintLabel);
    style.size = theme.type().large;
    const double room = 0.94 * painter.sheet().width();
    Point at = 0.5 * painter.sheet().max;
    for (const std::string& line : lines)
        for (const std::string& part : wrapped_lines(painter.fonts(), line, style, room)) {
            painter.text(at, part, style);
            at = at + Point{0.0, 1.6 * style.size};
        }
}

} // namespace ui
