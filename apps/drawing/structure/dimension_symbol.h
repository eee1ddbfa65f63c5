#pragma once

#include "apps/drawing/sketch/scene.h"

#include <string>

namespace drawing {

/// One length between two points of the sheet: a line with a tick at each end and the length beside it.
struct DimensionSymbol {
    ui::Point start, end;
    ui::Point outward; ///< the side on which the length stands
    double length = 0.0;
};
void draw(const Scene& scene, const DimensionSymbol& symbol);

/// "4.5 m", as the symbol says it.
std::string length_text(const Scene& scene, double length);

} // namespace drawing
