#pragma once

#include <algorithm>
#include <cmath>

namespace ui {

/// How many cells of a grid lie along a side of this length, at least one and at most `most`; both lengths in [px].
inline int n_cells(double length, double cell_side, double most)
{
    return static_cast<int>(std::clamp(std::ceil(length / cell_side), 1.0, most));
}

} // namespace ui
