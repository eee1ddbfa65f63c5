#include "apps/mohr/window/canvas.h"

#include <imgui.h>

namespace mohr {

void Canvas::show(Session& session, ui::ImGuiSession& gui)
{
    if (!begin(gui, left_button)) return;
    follow(session);
    paint([&](ui::Painter& painter) { drawn_ = draw(painter, session.scene()); });
    end(gui);
}

void Canvas::follow(Session& session)
{
    if (!session.held()) {
        const double reach = 14.0 * ui::Theme(session.look.theme).symbol_scale();
        const bool can_drag = is_over() && !session.is_concealing(); // an exercise keeps its state
        session.hover = can_drag ? pick(drawn_, pointer(), reach) : std::nullopt;
        if (session.hover && is_pressed()) session.grip(*session.hover, drawn_);
        else if (is_in_space(session.document().subject)) turn_eye(session);
    } else if (is_active()) {
        if (is_dragged()) session.drag_to(pointer(), ImGui::GetIO().KeyShift);
    } else {
        session.settle();
    }
    if (session.hover || session.held()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

void Canvas::turn_eye(Session& session)
{
    const ui::ViewMove hand = view_move({.left = is_active(), .middle = false, .right = false});
    if (hand.is_drag()) session.eye.orbit(hand.drag, {});
}

ui::Picture Canvas::picture_of(const Session& session) const
{
    Scene scene = session.scene();
    scene.hover.reset();
    return painted([&](ui::Painter& painter) { draw(painter, scene); });
}

std::optional<ui::Point> Canvas::in_window(Handle handle) const
{
    for (const Place& place : drawn_.places)
        if (place.handle == handle) return corner() + place.at;
    return std::nullopt;
}

} // namespace mohr
