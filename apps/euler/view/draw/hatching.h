#pragma once

#include "apps/euler/view/shapes/outline.h"
#include "ui/paint/painter.h"

namespace euler {

/// Parallel lines across an area, at 45 degrees. Lines of neighbouring areas run on in one another.
void hatch(ui::Painter& painter, const Region& area, double spacing, const ui::Stroke& stroke);

} // namespace euler
