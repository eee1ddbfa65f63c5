#pragma once

#include "femoop/section/section_properties.h"

namespace femoop {

/// The axes through the centroid about which the second moment of area is largest and least.
///
///        y' |   / 1      I(t) = integral of (y' cos t - z' sin t)^2 = Iz cos^2 t + Iy sin^2 t - 2 Iyz sin t cos t
///           |  /
///           | / t        t from z' to axis 1, counter-clockwise as seen with y' up and z' to the right
///           o------ z'
///
/// Units   second moments in those of the properties, the angle in rad, in (-pi/2, pi/2]; 0 where both are equal
/// Source  [GereTimoshenko], principal axes and principal moments of inertia
struct PrincipalAxes {
    double I1 = 0.0, I2 = 0.0; ///< I1 >= I2
    double angle = 0.0;
};

PrincipalAxes principal_axes(const SectionProperties& section);

} // namespace femoop
