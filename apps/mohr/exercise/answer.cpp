#include "apps/mohr/exercise/answer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "apps/mohr/document/degree.h"
#include "femoop/methods/mohr/state.h"

namespace mohr {

namespace fm = femoop::mohr;
using enum Asked;

namespace {

constexpr double stress_per_strain = 1e-3; // MPa of a strain of 1e-6 times E in GPa

double given_shear(const Exercise& e, double xy)
{
    return is_strain(e.topic) ? 2.0 * xy : e.topic == ExerciseTopic::Inertia ? -xy : xy;
}

/// Of gauges at 0, 45, 90 or 0, 60, 120 degrees.
double from_rosette(Asked asked, const Exercise& e)
{
    const auto [a, b, c] = e.readings;
    const bool is_delta = e.gauges == fm::rosette_60_degrees;
    if (asked == StrainX) return a;
    if (asked == StrainY) return is_delta ? (2.0 * b + 2.0 * c - a) / 3.0 : c;
    return is_delta ? 2.0 / std::numbers::sqrt3 * (b - c) : 2.0 * b - a - c;
}

/// The roots of the characteristic equation in order; those of the tensor where the invariants have no three.
std::array<double, 3> space_values(const Exercise& e, const Numbers& n)
{
    if (e.difficulty != Difficulty::Hard) {
        std::array values{n[Centre] + n[Radius], n[Centre] - n[Radius], e.space.z};
        std::ranges::sort(values, std::greater{});
        return values;
    }
    const double mean = n[I1] / 3.0, p = mean * mean - n[I2] / 3.0;
    const double q = mean * mean * mean - 0.5 * mean * n[I2] + 0.5 * n[I3];
    if (!(p > 0.0) || std::abs(q) > std::pow(p, 1.5) * (1.0 + 1e-9)) return fm::principal(e.space).values;
    const double third = std::acos(std::clamp(q / std::pow(p, 1.5), -1.0, 1.0)) / 3.0, reach = 2.0 * std::sqrt(p);
    const double turn = 2.0 * std::numbers::pi / 3.0;
    return {mean + reach * std::cos(third), mean + reach * std::cos(third - turn),
            mean + reach * std::cos(third + turn)};
}

/// The three principal stresses, largest first; those of a plane stress with the 0 across it.
std::array<double, 3> stresses(const Exercise& e, const Numbers& n)
{
    if (e.topic == ExerciseTopic::Space) return {n[SpaceFirst], n[SpaceSecond], n[SpaceThird]};
    std::array values{n[First], n[Second], n[Third]};
    std::ranges::sort(values, std::greater{});
    return values;
}

double from_space(Asked asked, const Exercise& e, const Numbers& n)
{
    const auto [s1, s2, s3] = stresses(e, n);
    const auto on = [&] { return fm::on_plane(e.space, {e.normal[0], e.normal[1], e.normal[2]}); };
    switch (asked) {
    case I1: return fm::invariants(e.space).I1;
    case I2: return fm::invariants(e.space).I2;
    case I3: return fm::invariants(e.space).I3;
    case SpaceFirst: return space_values(e, n)[0];
    case SpaceSecond: return space_values(e, n)[1];
    case SpaceThird: return space_values(e, n)[2];
    case LargestShear: return 0.5 * (s1 - s3);
    case Mean: return (s1 + s2 + s3) / 3.0;
    case VonMises: return std::hypot(s1 - s2, s2 - s3, s1 - s3) / std::numbers::sqrt2;
    case SpaceNormal: return on().normal_component;
    case SpaceShear: return on().shear;
    default: return 0.0;
    }
}

double from_material(Asked asked, const Exercise& e, const Numbers& n)
{
    const auto [s1, s2, s3] = stresses(e, n);
    const fm::Strength& k = e.strength;
    switch (asked) {
    case StressFirst: return stress_per_strain * e.E / (1.0 - e.nu * e.nu) * (n[First] + e.nu * n[Second]);
    case StressSecond: return stress_per_strain * e.E / (1.0 - e.nu * e.nu) * (n[Second] + e.nu * n[First]);
    case FactorTresca: return k.fy / (s1 - s3);
    case FactorVonMises: return k.fy / n[VonMises];
    case FactorRankine: return 1.0 / std::max(s1 / k.ft, -s3 / k.fc);
    case FactorCoulomb: return k.c * std::cos(k.phi) / (0.5 * (s1 - s3) + 0.5 * (s1 + s3) * std::sin(k.phi));
    default: return 0.0;
    }
}

double third(const Exercise& e, const Numbers& n)
{
    if (e.topic == ExerciseTopic::PlaneStrain) return e.nu * (e.state.x + e.state.y);
    return is_strain(e.topic) ? -e.nu / (1.0 - e.nu) * (n[First] + n[Second]) : 0.0;
}

template <class Answered> Numbers numbers(const Exercise& e, const Answered& answered)
{
    Numbers n;
    for (std::size_t i = 0; i < n_asked; ++i) {
        const auto asked = static_cast<Asked>(i);
        n[asked] = answered(asked).value_or(answer_from(asked, e, n));
    }
    return n;
}

/// What numbers of this kind reach.
double size_of(Asked asked, const Exercise& e, double right)
{
    if (asked >= FactorTresca) return 2.0 * std::abs(right);
    if (asked == StressFirst || asked == StressSecond)
        return std::max(std::abs(solution_of(StressFirst, e)), std::abs(solution_of(StressSecond, e)));
    if (e.topic == ExerciseTopic::Space) {
        const auto values = fm::principal(e.space).values;
        const double largest = std::max(std::abs(values[0]), std::abs(values[2]));
        const double power = asked == I2 ? 2.0 : 3.0;
        return asked == I2 || asked == I3 ? std::max(std::abs(right), 0.05 * std::pow(largest, power)) : largest;
    }
    const fm::PlanePrincipal p = fm::principal(e.state);
    return std::max(std::abs(p.first), std::abs(p.second));
}

} // namespace

fm::PlaneState state_of(const Exercise& e, const Numbers& n)
{
    return e.topic == ExerciseTopic::Rosette ? fm::PlaneState{n[StrainX], n[StrainY], 0.5 * n[ShearStrain]} : e.state;
}

double answer_from(Asked asked, const Exercise& e, const Numbers& n)
{
    const auto [x, y, xy] = state_of(e, n);
    const double a = 0.5 * (x - y), twice = 2.0 * e.angle * degree;
    switch (asked) {
    case StrainX:
    case StrainY:
    case ShearStrain: return from_rosette(asked, e);
    case Centre: return 0.5 * (x + y);
    case Radius: return std::hypot(x - n[Centre], xy);
    case First: return n[Centre] + n[Radius];
    case Second: return n[Centre] - n[Radius];
    case Direction: return 0.5 * std::atan2(xy, a) / degree;
    case Normal: return n[Centre] + a * std::cos(twice) + xy * std::sin(twice);
    case Shear: return given_shear(e, xy * std::cos(twice) - a * std::sin(twice));
    case LargestShearStrain: return 2.0 * n[Radius];
    case Third: return third(e, n);
    default: break;
    }
    return asked == StressFirst || asked == StressSecond || asked >= FactorTresca ? from_material(asked, e, n)
                                                                                  : from_space(asked, e, n);
}

Numbers right_numbers(const Exercise& e)
{
    return numbers(e, [](Asked) { return std::optional<double>(); });
}

Numbers own_numbers(const Exercise& e, std::span<const std::optional<double>> answers)
{
    return numbers(e, [&](Asked asked) {
        const auto place = static_cast<std::size_t>(std::ranges::find(e.asked, asked) - e.asked.begin());
        return place < std::min(answers.size(), e.asked.size()) ? answers[place] : std::nullopt;
    });
}

double solution_of(Asked asked, const Exercise& e) { return right_numbers(e)[asked]; }

bool is_near(Asked asked, const Exercise& e, double a, double b)
{
    if (asked == Direction) return std::abs(std::remainder(a - b, 180.0)) <= 0.2;
    return std::abs(a - b) <= 0.005 * size_of(asked, e, solution_of(asked, e));
}

} // namespace mohr
