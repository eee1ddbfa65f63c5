#pragma once

#include "ui/paint/painter.h"

#include <span>

namespace euler {

/// Parallel lines across a polygon, at 45 degrees. Lines of neighbouring polygons run on in one another.
void hatch(ui::Painter& painter, std::span<const ui::Point> outline, double spacing, const ui::Stroke& stroke);

} // namespace euler
