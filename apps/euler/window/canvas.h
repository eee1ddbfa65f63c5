#pragma once

#include <optional>
#include <span>
#include <string>

#include "apps/euler/session/commands.h"
#include "apps/euler/view/shapes/shapes.h"
#include "topology/geometry/point.h"
#include "ui/context/imgui_session.h"
#include "ui/paint/painter.h"

namespace euler {

/// The picture in the middle of the window: it shows the solids, is moved by the mouse, and says what lies under the
/// pointer. A click selects, or gives the operator that asks its next argument.
///
///     wheel: zoom to the cursor      left button: orbit      middle or right button, or Shift and the left: pan
///     double click on nothing: show everything
class Canvas {
public:
    explicit Canvas(const ui::Fonts& fonts) : fonts_(fonts) {}

    /// Fills what is left of the current window of Dear ImGui's.
    void show(Session& session, ui::ImGuiSession& gui);
    void zoom(Session& session, double factor) const;
    static void look(Session& session, ui::StandardView view);

    /// Where an entity of a solid lies in the window [logical pixels]; nothing where it is not to be seen.
    std::optional<ui::Point> in_window(const Part& part) const;
    /// Where a place in space lies.
    ui::Point in_window(const Session& session, const topology::Point& place) const;
    /// The solids as they are seen now, without what the pointer does.
    ui::Picture picture_of(const Session& session) const;
    /// The picture that was drawn last, for golden texts.
    const std::optional<ui::Picture>& picture() const { return picture_; }

private:
    void follow(Session& session, ui::Point at);
    void move_camera(Session& session, ui::Point at);
    void click(Session& session, const std::optional<Part>& under) const;
    void tell(const Session& session) const;
    void draw_line(Session& session, ui::Point at);
    topology::Point place(const Session& session, ui::Point at) const;
    void paint_drawing(const Session& session, ui::Painter& painter) const;
    void fit(Session& session) const;
    void give_room_to_draw(Session& session) const;
    Shapes shapes_of(const Session& session, std::span<const Subject> subjects) const;
    void paint(const Session& session);

    const ui::Fonts& fonts_;
    ui::Size sheet_{};
    ui::Point corner_{}; ///< of the sheet in the window [logical pixels]
    Shapes shapes_;      ///< drawn last
    std::optional<ui::Picture> picture_;
    bool is_dragging_ = false;
    std::optional<topology::Point> line_start_{}, line_end_{}; ///< of a line that is being drawn
};

/// "vertex v1", in the language of the session.
std::string describe(const Session& session, const Part& part);

} // namespace euler
