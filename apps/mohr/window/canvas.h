#pragma once

#include <optional>

#include "apps/mohr/session/session.h"
#include "ui/app/canvas.h"

namespace mohr {

/// The picture of a session, and what a hand does on it: handles are dragged, the cube and the sphere are turned beside
/// them.
class Canvas : public ui::Canvas {
public:
    using ui::Canvas::Canvas;

    /// \pre within a window of Dear ImGui's, which it fills
    void show(Session& session, ui::ImGuiSession& gui);

    /// The picture without what the pointer marks.
    ui::Picture picture_of(const Session& session) const;
    /// Where a handle is in the window [logical pixels]; nothing where the picture has none such.
    std::optional<ui::Point> in_window(Handle handle) const;
    const Drawn& drawn() const { return drawn_; }

private:
    void follow(Session& session);
    void turn_eye(Session& session);

    Drawn drawn_;
};

} // namespace mohr
