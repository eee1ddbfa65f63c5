#pragma once

#include "apps/mohr/view/scene.h"

namespace mohr {

/// Normal component and shear of the plane against its angle, from -90 to 90 degrees, with the plane that is looked at.
void draw_curves(ui::Painter& painter, const Scene& scene, const ui::Box& box, Drawn& drawn);

} // namespace mohr
