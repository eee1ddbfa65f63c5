#include "femoop/methods/mohr/rosette.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace femoop::mohr {

std::optional<SameDirection> why_not(const Rosette& rosette)
{
    constexpr double least = 0.1 * std::numbers::pi / 180.0;
    for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 1}, {0, 2}, {1, 2}})
        if (std::abs(as_direction(rosette.angles[i] - rosette.angles[j])) < least) return SameDirection{i, j};
    return std::nullopt;
}

PlaneState strain(const Rosette& rosette)
{
    // Seen from the first gauge, c + a = its reading, and two equations for a and b are left:
    //     e_i - e_1 = a (cos 2t - 1) + b sin 2t = 2 sin t (-a sin t + b cos t),   t = t_i - t_1
    std::array<double, 3> t{}, slope{};
    for (std::size_t i = 1; i < 3; ++i) {
        t[i] = rosette.angles[i] - rosette.angles[0];
        slope[i] = (rosette.readings[i] - rosette.readings[0]) / (2.0 * std::sin(t[i]));
    }
    const double determinant = std::sin(t[2] - t[1]);
    double a = (slope[1] * std::cos(t[2]) - slope[2] * std::cos(t[1])) / determinant;
    double b = (slope[1] * std::sin(t[2]) - slope[2] * std::sin(t[1])) / determinant;
    const double largest = std::max(
        {std::abs(rosette.readings[0]), std::abs(rosette.readings[1]), std::abs(rosette.readings[2])});
    const double condition = 1.0 / std::abs(determinant * std::sin(t[1]) * std::sin(t[2]));
    const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * condition * largest;
    const auto clean = [&](double value) { return std::abs(value) <= rounding ? 0.0 : value; };
    a = clean(a);
    b = clean(b);
    const double c = clean(rosette.readings[0] - a);
    const PlaneState strain = rotated({clean(c + a), clean(c - a), b}, -rosette.angles[0]);
    return {clean(strain.x), clean(strain.y), clean(strain.xy)};
}

} // namespace femoop::mohr
