#include "apps/mohr/window/canvas.h"

#include <imgui.h>

#include "ui/canvas/click.h"

namespace mohr {

namespace {

bool is_dragging() { return ImGui::IsMouseDragging(ImGuiMouseButton_Left, static_cast<float>(ui::click_reach)); }

} // namespace

void Canvas::show(Session& session, ui::ImGuiSession& gui)
{
    if (!area_.begin(gui)) return;
    follow(session, area_.pointer());
    paint(session);
    area_.show(*picture_, gui);
}

void Canvas::follow(Session& session, ui::Point at)
{
    if (!session.held()) {
        const double reach = 14.0 * ui::Theme(session.look.theme).symbol_scale();
        const bool can_drag = ImGui::IsItemHovered() && !session.is_concealing(); // an exercise keeps its state
        session.hover = can_drag ? pick(drawn_, at, reach) : std::nullopt;
        if (session.hover && ImGui::IsItemActivated()) session.grip(*session.hover, drawn_);
        else if (ImGui::IsItemActive()) turn_eye(session);
    } else if (ImGui::IsItemActive()) {
        if (is_dragging()) session.drag_to(at, ImGui::GetIO().KeyShift);
    } else {
        session.settle();
    }
    if (session.hover || session.held()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

void Canvas::turn_eye(Session& session)
{
    if (!is_in_space(session.document().subject) || !is_dragging()) return;
    const ImVec2 delta = ImGui::GetIO().MouseDelta;
    session.eye.orbit({static_cast<double>(delta.x), static_cast<double>(delta.y)}, {});
}

void Canvas::paint(const Session& session)
{
    ui::Painter painter(area_.sheet(), fonts_);
    drawn_ = draw(painter, session.scene());
    picture_ = painter.picture();
}

ui::Picture Canvas::picture_of(const Session& session) const
{
    ui::Painter painter(area_.sheet(), fonts_);
    Scene scene = session.scene();
    scene.hover.reset();
    draw(painter, scene);
    return painter.picture();
}

std::optional<ui::Point> Canvas::in_window(Handle handle) const
{
    for (const Place& place : drawn_.places)
        if (place.handle == handle) return area_.corner() + place.at;
    return std::nullopt;
}

} // namespace mohr
