#pragma once

#include "apps/mohr/view/scene.h"

namespace mohr {

/// The section with its fibre, and beside it normal stress and shear over the depth. \pre scene.solution.section
void draw_section(ui::Painter& painter, const Scene& scene, const ui::Box& box, Drawn& drawn);

} // namespace mohr
