#pragma once

#include "apps/mohr/view/scene.h"

namespace mohr {

/// The element with its faces turned by the plane's angle, and what acts on them; below it, small, in its principal
/// directions and in those of the largest shear.
void draw_element(ui::Painter& painter, const Scene& scene, const ui::Box& box, Drawn& drawn);

} // namespace mohr
