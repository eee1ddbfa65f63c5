#pragma once

#include "apps/mohr/view/scene.h"

namespace mohr {

/// The cube with the stresses on the faces that are seen, whose arrows are pulled, and the oblique plane's cut.
void draw_cube(ui::Painter& painter, const Scene& scene, const ui::Box& box, Drawn& drawn);

/// A sphere of directions, on which the normal of the plane is dragged.
void draw_sphere(ui::Painter& painter, const Scene& scene, const ui::Box& box, Drawn& drawn);

/// What lies between the three circles, above the axis.
void draw_region(ui::Painter& painter, const Scene& scene, const ui::PlaneCamera& camera);

/// The three circles above the axis, what lies between them, and the plane's point.
void draw_three_circles(ui::Painter& painter, const Scene& scene, const ui::Box& box, Drawn& drawn);

} // namespace mohr
