#pragma once

#include <cstddef>
#include <optional>

#include "apps/plane/session/commands.h"
#include "ui/app/canvas.h"

namespace plane {

/// The picture in the middle of the window: the drawing, and what the hand does in it.
///
///     wheel: zoom to the cursor      middle or right button, or the space bar held: pan
///     left button: what the tool does; dragging a point moves it, and all that hangs on it follows
///     right click: ends the curve that is begun      double click on nothing: show the whole drawing
class Canvas : public ui::Canvas {
public:
    using ui::Canvas::Canvas;

    /// \pre within a window of Dear ImGui's, which it fills
    void show(Workspace& workspace, ui::ImGuiSession& gui);

    void fit(Session& session);
    void zoom(Session& session, double factor) const;
    /// The drawing without what the hand does.
    ui::Picture picture_of(const Workspace& workspace) const;
    /// Where a place of the drawing is in the window [logical pixels].
    ui::Point in_window(const FlatPoint& place) const;
    /// Gives up a drag; false where there is none.
    bool cancel(Workspace& workspace);

private:
    void fit_if_needed(const Workspace& workspace);
    bool is_beside_body() const; ///< the pointer, over a legend or a panel
    bool is_all_in_sight(const Session& session) const;
    ui::PlaneCamera usual_camera(const Session& session) const;
    FlatPoint place_at(ui::Point on_sheet) const;
    void move_camera(Session& session);
    Aim aim_at(const Workspace& workspace) const;
    void follow(Workspace& workspace);
    void press(Workspace& workspace, const Aim& aim);
    bool has_lost_its_hold(const Session& session) const;
    void let_go();
    void drag(Workspace& workspace);
    void release(Workspace& workspace, const Aim& aim);
    void drag_reading(Workspace& workspace);
    std::optional<ReadingPart> reading_under(const Session& session, const FlatPoint& at, double reach) const;
    void end_by_right_click(Workspace& workspace);
    ui::Box paint_all(const Workspace& workspace, ui::Painter& painter) const; ///< \returns the room of the body

    ui::PlaneCamera camera_;
    ui::Box room_{};     ///< of the sheet, for the body, as it was painted last
    ui::Point margin_{}; ///< right of that room and below it
    struct FittedFor {
        std::size_t opening;
        ui::Size sheet;
        ui::ThemeName theme;
        femoop::CaseId load_case; ///< whose loads take room
        std::ptrdiff_t n_loads;
        PlateShown show;           ///< legends and marks take room
        bool has_circle, has_cuts; ///< and panels
        bool is_beside;            ///< another body, which takes half of it
        bool is_loose;             ///< it swings as far as it can move
        bool operator==(const FittedFor&) const = default;
    };
    std::optional<FittedFor> fitted_for_;
    int fitted_in_ = 0;                      ///< the frame
    std::optional<ui::Point> fitted_margin_; ///< when the picture was fitted last
    std::optional<NodeId> grip_;             ///< the point that the hand drags
    std::string gripped_;                    ///< its name
    std::optional<Aim> pressed_;
    std::size_t pressed_in_ = 0; ///< the document, by its opening
    struct HeldReading {
        ReadingPart part;
        Readings before;    ///< the drag, which Escape gives back
        Readings as_left{}; ///< by the hand
    };
    std::optional<HeldReading> held_reading_;
    std::optional<mohr::Frame> circle_frame_; ///< grows while a probe is dragged
};

} // namespace plane
