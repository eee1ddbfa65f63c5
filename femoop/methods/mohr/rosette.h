#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "femoop/methods/mohr/plane_state.h"

namespace femoop::mohr {

/// Three strain gauges at one point of a surface, each measuring the elongation along its own direction.
///
///     45 deg: 0, 45, 90       60 deg (delta): 0, 60, 120       free: any three directions
///
///     e(t) = c + a cos 2t + b sin 2t,   ex = c + a,  ey = c - a,  gamma_xy = 2 b
///
/// Signs   elongation positive, angles from x, counter-clockwise
/// Units   readings in any unit of strain, angles in rad
/// Source  [HibbelerMechanics], strain rosettes
struct Rosette {
    std::array<double, 3> angles{};
    std::array<double, 3> readings{};
};

inline constexpr std::array<double, 3> rosette_45_degrees{0.0, 45.0, 90.0};
inline constexpr std::array<double, 3> rosette_60_degrees{0.0, 60.0, 120.0};

/// Two gauges of which one measures what the other does: their directions agree within 0.1 degree, so that the third
/// unknown would be made of errors of reading.
struct SameDirection {
    std::size_t first = 0, second = 0;
};
std::optional<SameDirection> why_not(const Rosette& rosette);

/// The strain; xy is gamma_xy / 2. What is rounding alone beside the readings is 0.
/// \pre `why_not` has nothing to say
PlaneState strain(const Rosette& rosette);

} // namespace femoop::mohr
