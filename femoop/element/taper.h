#pragma once

#include <array>
#include <limits>

namespace femoop {

/// How the stiffnesses of a member vary whose depth changes linearly along it, each beside its value at the first end.
///
///      h(x)  = h(0) (1 + depth x)           EA(x)  = EA (1 + area x)
///      EI(x) = EI (1 + a1 x + a2 x^2 + a3 x^3)      GAs(x) = GAs (1 + shear_area x)
///
/// Units    1 / length; a3 in 1 / length^3
/// Assumes  the axis is straight and every section is symmetric about it
struct Taper {
    double depth = 0.0;
    double area = 0.0;
    double shear_area = 0.0;
    std::array<double, 3> inertia{}; ///< a1, a2, a3
    /// Over pieces up to this length power series of 1 / EI, 1 / EA and 1 / GAs give every digit.
    double longest_piece = std::numeric_limits<double>::infinity();

    bool is_prismatic() const { return depth == 0.0; }
};

} // namespace femoop
