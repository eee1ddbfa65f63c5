#pragma once

#include <vector>

#include "femoop/plane/model/plane_expected.h"
#include "ui/paint/color.h"
#include "ui/paint/theme.h"

namespace plane {

/// The colours of the bands between levels: where a range has both signs, blue below zero and vermillion above it, the
/// stronger the farther from it; else from pale to strong. People with any common colour blindness tell them apart; in
/// print they are shades of gray.
std::vector<ui::Color> band_colors(const std::vector<double>& levels, const ui::Theme& theme);

} // namespace plane
