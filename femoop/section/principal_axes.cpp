#include "femoop/section/principal_axes.h"

#include <cmath>

namespace femoop {

PrincipalAxes principal_axes(const SectionProperties& section)
{
    const double mean = 0.5 * (section.Iz + section.Iy), half = 0.5 * (section.Iz - section.Iy);
    const double radius = std::hypot(half, section.Iyz);
    const double angle = radius > 0.0 ? 0.5 * std::atan2(-section.Iyz, half) : 0.0;
    return {.I1 = mean + radius, .I2 = mean - radius, .angle = angle};
}

} // namespace femoop
