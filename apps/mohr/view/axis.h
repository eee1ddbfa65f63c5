#pragma once

#include <string>

#include "ui/paint/painter.h"

namespace mohr {

/// A round step (1, 2, 5 times a power of ten) of at least so many pixels.
double tick_step(double pixels_per_unit, double least_pixels);

/// The word beside an axis: "σ [MPa]", the name alone where there is no unit.
std::string axis_title(const std::string& name, const std::string& unit);

} // namespace mohr
