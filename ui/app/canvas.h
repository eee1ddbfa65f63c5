#pragma once

#include <imgui.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "ui/context/imgui_session.h"
#include "ui/paint/geometry.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"

namespace ui {

/// The buttons that move the view in this frame.
struct ViewButtons {
    bool left = false, middle = true, right = true;
    bool move_at_once = false; ///< before it is known to be a drag
};

/// What the hand does with a view in one frame.
struct ViewMove {
    double wheel = 0.0;   ///< notches, away from the hand
    Point drag{};         ///< [logical pixels]
    bool is_left = false; ///< the drag is the left button's, not the middle or right one's

    bool is_drag() const { return drag != Point{}; }
    /// About the pointer. \param notch  what one of the wheel enlarges by
    double zoom(double notch = 1.15) const { return std::pow(notch, wheel); }
};

/// The picture in the middle of an app's window: where it lies, what the hand does on it, and what was painted. An app's
/// own canvas is derived from it: once a frame it calls `begin`, follows the hand, paints, and calls `end`.
class Canvas {
public:
    /// \pre the fonts outlive it
    explicit Canvas(const Fonts& fonts) : fonts_(fonts) {}

    /// The picture that was painted last, for golden texts.
    const std::optional<Picture>& picture() const { return picture_; }
    Point corner() const { return corner_; } ///< of the sheet in the window [logical pixels]

protected:
    ~Canvas() = default;

    static constexpr ImGuiButtonFlags left_button = ImGuiButtonFlags_MouseButtonLeft;
    static constexpr ImGuiButtonFlags any_button = left_button | ImGuiButtonFlags_MouseButtonMiddle |
                                                   ImGuiButtonFlags_MouseButtonRight;
    /// Takes what is left of Dear ImGui's current window, as an item that hears these buttons. False where that is no
    /// room for a picture; then there is none in this frame.
    bool begin(const ImGuiSession& gui, ImGuiButtonFlags buttons);
    void end(ImGuiSession& gui) const; ///< shows what was painted

    /// What `draw` draws with a painter on the sheet.
    template <class Draw> Picture painted(const Draw& draw) const
    {
        Painter painter(sheet_, fonts_);
        draw(painter);
        return painter.picture();
    }
    template <class Draw> void paint(const Draw& draw) { picture_ = painted(draw); }

    const Fonts& fonts() const { return fonts_; }
    Size sheet() const { return sheet_; }      ///< [logical pixels]
    Point pointer() const { return pointer_; } ///< on the sheet, or beside it
    Point middle() const { return 0.5 * Point{sheet_.width, sheet_.height}; }

    bool is_over() const { return is_over_; }         ///< the pointer, and nothing lies between
    bool is_active() const { return is_active_; }     ///< a button went down on it and is held
    bool is_pressed() const { return is_pressed_; }   ///< in this frame the left button went down on it
    bool is_released() const { return is_released_; } ///< in this frame it is active no more
    Point pressed_at() const { return pressed_at_; }  ///< where the left button went down last
    bool is_dragged() const { return is_dragged_; }   ///< since then the pointer was farther than a click reaches

    /// The gesture that moves the view.
    ViewMove view_move(ViewButtons buttons);
    bool has_hold_of_view() const { return hold_.has_value(); } ///< a button that moves it is down
    /// The view is being moved, or was until this frame: the release of a drag is no click.
    bool is_moving_view() const { return is_moving_view_; }

private:
    const Fonts& fonts_;
    std::optional<Picture> picture_;
    Size sheet_{900.0, 700.0};
    Point corner_{}, pointer_{}, pressed_at_{};
    bool is_over_ = false, is_active_ = false, is_pressed_ = false, is_released_ = false, is_dragged_ = false;
    std::optional<Point> hold_; ///< where in the window the hand that moves the view was last [logical pixels]
    bool is_moving_view_ = false;
    ImVec2 corner_pixel_{}, room_{}; ///< [pixels of the window]
};

/// How to begin, in the middle of an empty sheet, in more lines where it is narrow.
void draw_invitation(Painter& painter, const Theme& theme, const std::vector<std::string>& lines);

} // namespace ui
