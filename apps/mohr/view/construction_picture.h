#pragma once

#include "apps/mohr/view/scene.h"

namespace mohr {

/// The circle as far as it is constructed: what the last step added in a colour of its own, with the marks of compass
/// and ruler, and its caption below. \pre scene.steps_shown
void draw_construction(ui::Painter& painter, const Scene& scene, const ui::Box& box, Drawn& drawn);

} // namespace mohr
