#pragma once

#include "apps/euler/view/shapes/outline.h"
#include "ui/paint/painter.h"

#include <span>

namespace euler {

/// Parallel lines across an area, at 45 degrees, as far as nothing covers it. Lines of neighbouring areas run on in one
/// another.
void hatch(ui::Painter& painter, const Region& area, std::span<const Region* const> covers, double spacing,
           const ui::Stroke& stroke);

} // namespace euler
