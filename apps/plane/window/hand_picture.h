#pragma once

#include "apps/plane/session/commands.h"
#include "ui/canvas/plane_camera.h"
#include "ui/paint/painter.h"

namespace plane {

/// How far the lines of the grid are apart at this scale [length].
double grid_step(const ui::PlaneCamera& camera);

/// Points that are no vertices, such as centres and control points: they can be dragged too.
/// \param room  of the sheet, for the body, here as below
void draw_helpers(ui::Painter& painter, const Session& session, const ui::PlaneCamera& camera, const ui::Box& room);
/// What is selected, and what lies under the pointer.
void draw_highlight(ui::Painter& painter, const Session& session, const ui::PlaneCamera& camera, const ui::Box& room);

/// What the hand is about to draw: the curve as it would be, the place that is meant, what is typed.
void draw_hand(ui::Painter& painter, const Workspace& workspace, const ui::PlaneCamera& camera, const ui::Box& room,
               bool is_dragging);
/// The places of a curve that is begun, where the pointer is not over the picture.
void draw_begun(ui::Painter& painter, const Workspace& workspace, const ui::PlaneCamera& camera, const ui::Box& room);
/// What is typed, where the pointer is not over the picture.
void draw_typed_at_foot(ui::Painter& painter, const Workspace& workspace);
/// Where the drawing has faults, and the gap of an open outline.
void draw_problems(ui::Painter& painter, const Workspace& workspace, const ui::PlaneCamera& camera);

} // namespace plane
