#pragma once

#include <optional>
#include <vector>

#include "femoop/methods/mohr/criterion.h"

namespace femoop::mohr {

/// What a criterion bounds in the space of principal stresses, cut by a plane: where circles cannot show it, because it
/// needs all three of them.

/// Two principal stresses of a plane, in any order.
struct StressPair {
    double first = 0.0, second = 0.0;
};

/// The pairs at which a material fails, in `n` directions from the origin, counter-clockwise from the axis of the
/// first: the third principal stress is `share` (first + second). A direction in which it never fails ends at `reach`.
/// \param share  0 of a plane stress, Poisson's ratio of a plane strain
std::vector<StressPair> failing_pairs(Criterion criterion, const Strength& strength, double share, double reach,
                                      std::size_t n);

/// The size of the deviator, sqrt(2 J2), at which a stress of this mean and Lode angle fails: its distance from the
/// hydrostatic axis in the deviatoric plane. Absent where it never fails; 0 where the mean alone does.
/// \param lode  0 to pi/3, as of `Deviator`
std::optional<double> failing_deviator(Criterion criterion, const Strength& strength, double mean, double lode);

} // namespace femoop::mohr
