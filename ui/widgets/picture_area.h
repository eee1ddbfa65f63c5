#pragma once

#include <imgui.h>

#include "ui/context/imgui_session.h"
#include "ui/paint/geometry.h"
#include "ui/paint/picture.h"

namespace ui {

/// What the hand does with a view in one frame.
struct ViewMove {
    double zoom = 1.0;    ///< about the pointer, by the wheel
    Point drag{};         ///< [logical pixels]
    bool is_left = false; ///< the drag is the left button's, not the middle or right one's

    bool is_drag() const { return drag != Point{}; }
};

inline constexpr ImGuiButtonFlags any_button = ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                                               ImGuiButtonFlags_MouseButtonRight;

/// The part of a window that a picture fills: where it lies, where the pointer is on it, and the gesture that moves the
/// view. Call `begin`, then the rest, once a frame.
class PictureArea {
public:
    /// Takes what is left of Dear ImGui's current window, as an item that hears these buttons. False where that is no
    /// room for a picture; then there is none in this frame.
    bool begin(const ImGuiSession& gui, ImGuiButtonFlags buttons = ImGuiButtonFlags_MouseButtonLeft);
    void show(const Picture& picture, ImGuiSession& gui) const;

    Size sheet() const { return sheet_; }      ///< [logical pixels]
    Point corner() const { return corner_; }   ///< of the sheet in the window [logical pixels]
    Point pointer() const { return pointer_; } ///< on the sheet, or beside it
    Point middle() const { return 0.5 * Point{sheet_.width, sheet_.height}; }

    enum class LeftButton { Works, MovesView, MovesViewAtOnce }; ///< at once: before it is known to be a drag
    ViewMove view_move(LeftButton left);
    /// The view is being moved, or was until this frame: the release of a drag is no click.
    bool is_moving_view() const { return is_moving_view_; }

private:
    Size sheet_{900.0, 700.0};
    Point corner_{};
    Point pointer_{};
    ImVec2 corner_pixel_{}, room_{}; ///< [pixels of the window]
    float pixels_ = 1.0F;            ///< of the window for a logical one
    bool is_moving_view_ = false;
};

} // namespace ui
