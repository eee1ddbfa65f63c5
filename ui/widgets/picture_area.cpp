#include "ui/widgets/picture_area.h"

#include <cmath>

namespace ui {

namespace {

constexpr double zoom_per_turn = 1.15;

Point logical(ImVec2 v, float pixels) { return {static_cast<double>(v.x / pixels), static_cast<double>(v.y / pixels)}; }

} // namespace

bool PictureArea::begin(const ImGuiSession& gui, ImGuiButtonFlags buttons)
{
    constexpr float least = 8.0F;
    corner_pixel_ = ImGui::GetCursorScreenPos();
    room_ = ImGui::GetContentRegionAvail();
    if (room_.x < least || room_.y < least) return false;
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    pixels_ = static_cast<float>(gui.scale());
    corner_ = logical(corner_pixel_, pixels_);
    pointer_ = logical({pointer.x - corner_pixel_.x, pointer.y - corner_pixel_.y}, pixels_);
    const Point size = logical(room_, pixels_);
    sheet_ = {size.x, size.y};
    ImGui::InvisibleButton("canvas", room_, buttons);
    return true;
}

void PictureArea::show(const Picture& picture, ImGuiSession& gui) const
{
    const ImVec2 &a = corner_pixel_, b{a.x + room_.x, a.y + room_.y};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect(a, b, true);
    gui.show(picture, list, {static_cast<double>(a.x), static_cast<double>(a.y)});
    list.PopClipRect();
}

ViewMove PictureArea::view_move(LeftButton left)
{
    const ImGuiIO& io = ImGui::GetIO();
    ViewMove move;
    if (io.MouseWheel != 0.0F) move.zoom = std::pow(zoom_per_turn, static_cast<double>(io.MouseWheel));
    const auto is_held = [&](ImGuiMouseButton button) {
        return ImGui::IsMouseDown(button) && (button != ImGuiMouseButton_Left || left != LeftButton::Works);
    };
    bool is_any_held = false, is_dragged = left == LeftButton::MovesViewAtOnce;
    for (const auto button : {ImGuiMouseButton_Left, ImGuiMouseButton_Middle, ImGuiMouseButton_Right}) {
        is_any_held = is_any_held || is_held(button);
        is_dragged = is_dragged || (is_held(button) && ImGui::IsMouseDragging(button));
    }
    if (!is_any_held) {
        // The release of a drag is seen in the frame in which nothing is held any more.
        if (!ImGui::IsMouseReleased(ImGuiMouseButton_Left)) is_moving_view_ = false;
        return move;
    }
    is_moving_view_ = is_moving_view_ || is_dragged;
    if (!is_moving_view_) return move;
    move.drag = logical(io.MouseDelta, pixels_);
    move.is_left = is_held(ImGuiMouseButton_Left);
    return move;
}

} // namespace ui
