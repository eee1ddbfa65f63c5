#pragma once

#include "ui/paint/painter.h"

#include <vector>

namespace euler {

/// A filled triangle at the end of a line, pointing as the line's last stretch does.
void draw_head(ui::Painter& painter, const std::vector<ui::Point>& line, double length, ui::Color color);

} // namespace euler
