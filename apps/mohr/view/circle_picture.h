#pragma once

#include "apps/mohr/view/labels.h"
#include "apps/mohr/view/scene.h"

namespace mohr {

/// Where the circle's diagram puts a pair of components in a box.
ui::PlaneCamera circle_camera(const Frame& frame, const ui::Box& box, const Look& look);

/// The circle of a plane state: axes, points of the faces and of the plane, pole, criterion.
void draw_circle(ui::Painter& painter, const Scene& scene, const ui::Box& box, Drawn& drawn);

/// The rule of the shear's sign in words, along the foot of a box. \returns what is left for the diagram
ui::Box write_rule(ui::Painter& painter, const Scene& scene, const ui::Box& box);

/// The axes with their ticks and titles. Labels keep clear of them.
void draw_axes(ui::Painter& painter, const Scene& scene, const ui::Box& box, const ui::PlaneCamera& camera,
               Labels& labels);

/// What a criterion allows, and the largest circle as it is when it fails.
void draw_criterion(ui::Painter& painter, const Scene& scene, const ui::Box& box, const ui::PlaneCamera& camera);

/// A point of the diagram that may be dragged.
void draw_mark(ui::Painter& painter, const Scene& scene, ui::Point at, std::optional<Handle> handle, ui::Role role);

} // namespace mohr
