#pragma once

#include <optional>

#include "apps/mohr/session/session.h"
#include "ui/context/imgui_session.h"
#include "ui/paint/text_measure.h"
#include "ui/widgets/picture_area.h"

namespace mohr {

/// The picture of a session, and what a hand does on it: handles are dragged, the cube and the sphere are turned beside
/// them.
class Canvas {
public:
    explicit Canvas(const ui::Fonts& fonts) : fonts_(fonts) {}

    /// \pre within a window of Dear ImGui's, which it fills
    void show(Session& session, ui::ImGuiSession& gui);

    const std::optional<ui::Picture>& picture() const { return picture_; }
    /// The picture without what the pointer marks.
    ui::Picture picture_of(const Session& session) const;
    /// Where a handle is in the window [logical pixels]; nothing where the picture has none such.
    std::optional<ui::Point> in_window(Handle handle) const;
    const Drawn& drawn() const { return drawn_; }
    ui::Point corner() const { return area_.corner(); }

private:
    void follow(Session& session, ui::Point at);
    void turn_eye(Session& session);
    void paint(const Session& session);

    const ui::Fonts& fonts_;
    ui::PictureArea area_;
    Drawn drawn_;
    std::optional<ui::Picture> picture_;
};

} // namespace mohr
