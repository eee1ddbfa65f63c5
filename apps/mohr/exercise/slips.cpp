#include "apps/mohr/exercise/slips.h"

#include <algorithm>
#include <cmath>

#include "apps/mohr/document/degree.h"
#include "apps/mohr/exercise/slip_words.h"
#include "apps/mohr/exercise/space_slips.h"
#include "ui/text/catalogue.h"

namespace mohr {

namespace fm = femoop::mohr;
using enum Asked;
using ui::translatable;

namespace {

constexpr auto half_difference = translatable("this is half the difference: the centre is half the sum");
constexpr auto no_centre = translatable("the centre is left out: the circle does not lie about the origin");
constexpr auto once_for_twice = translatable("x′ turns by θ, the point on the circle by 2θ");
constexpr auto difference_not_halved = translatable("the difference is not halved");
constexpr auto whole_gamma = translatable("the circle counts half of γ");

std::string_view shear_direction(const Exercise& e)
{
    return is_inertia(e.topic) ? translatable("this is the direction of the largest product")
                               : translatable("this is the direction of the largest shear");
}

std::string_view sense_turned(const Exercise& e)
{
    return is_inertia(e.topic)
               ? translatable("the sense is turned: positive is counter-clockwise, and the product's sign counts")
               : translatable("the sense is turned: positive is counter-clockwise, and the shear's sign counts");
}

std::string_view shear_sign_turned(const Exercise& e)
{
    return is_inertia(e.topic)
               ? translatable("the sign of the product is turned: the circle counts −Ixy")
               : translatable("the sign of the shear is turned: on the face x′ it is positive along y′");
}

/// Components and what the circle has of them.
struct Plane {
    Plane(const Exercise& e, const Numbers& n) : state(state_of(e, n)), once(e.angle * degree) {}

    double half() const { return 0.5 * (state.x - state.y); }
    double along(double angle, double sense = 1.0) const
    {
        return half() * std::cos(angle) + sense * state.xy * std::sin(angle);
    }
    double across(double angle, double sense = 1.0) const
    {
        return state.xy * std::cos(angle) - sense * half() * std::sin(angle);
    }

    fm::PlaneState state;
    double once; ///< the angle of the plane [rad]
};

std::vector<Slip> rosette_slips(Asked asked, const Exercise& e)
{
    const auto [a, b, c] = e.readings;
    const bool is_delta = e.gauges == fm::rosette_60_degrees;
    constexpr auto other_gauge = translatable("this is the reading of another gauge");
    if (asked == StrainX) return {{b, other_gauge}, {c, other_gauge}};
    if (asked == StrainY && !is_delta) return {{a, other_gauge}, {b, other_gauge}};
    if (asked == StrainY)
        return {{c, translatable("no gauge measures along y: its strain follows from all three")},
                {2.0 * b + 2.0 * c - a, translatable("it is not divided by three: (2εb + 2εc − εa)/3")}};
    const double gamma = answer_from(ShearStrain, e, {});
    std::vector<Slip> all{
        {0.5 * gamma, translatable("this is γ/2, what the circle counts; γ itself is asked")},
        {-gamma, sign_turned},
        {b, translatable("the gauge between both axes measures no γ: its strain is half the sum plus γ/2")}};
    if (is_delta) all.push_back({b - c, translatable("the factor 2/√3 is missing")});
    return all;
}

std::vector<Slip> circle_slips(Asked asked, const Exercise& e, const Numbers& n)
{
    const Plane p(e, n);
    const auto [x, y, xy] = p.state;
    const double a = p.half();
    switch (asked) {
    case Centre:
        return {{a, half_difference},
                {-a, half_difference},
                {x + y, translatable("the sum is not halved")},
                {-0.5 * (x + y), translatable("the sign is turned: tension and elongation are positive")}};
    case Radius: {
        std::vector<Slip> all{
            {std::hypot(2.0 * a, xy), difference_not_halved},
            {std::abs(a) + std::abs(xy), translatable("the legs are added: the radius is the hypotenuse")},
            {a * a + xy * xy, no_root},
            {std::hypot(0.5 * (x + y), xy),
             translatable("this is the distance from the origin: the centre does not lie there")},
            {std::abs(a),
             is_inertia(e.topic) ? translatable("the product is left out") : translatable("the shear is left out")},
            {std::abs(xy), translatable("the half difference is left out")}};
        if (is_strain(e.topic)) all.push_back({std::hypot(a, 2.0 * xy), whole_gamma});
        return all;
    }
    case First:
        return {
            {n[Centre] - n[Radius],
             translatable("this is the smaller one: the first is the larger, counted with its sign")},
            {n[Radius], no_centre},
            {std::max(x, y), translatable("this is the larger of the given ones, whose direction is not principal")}};
    case Second:
        return {
            {n[Centre] + n[Radius],
             translatable("this is the larger one: the second is the smaller, counted with its sign")},
            {n[Radius] - n[Centre], translatable("the sign is turned: it is centre less radius")},
            {-n[Radius], no_centre},
            {std::min(x, y), translatable("this is the smaller of the given ones, whose direction is not principal")}};
    default: return {};
    }
}

std::vector<Slip> direction_slips(const Exercise& e, const Numbers& n)
{
    const Plane p(e, n);
    const double right = answer_from(Direction, e, n), a = p.half(), xy = p.state.xy;
    std::vector<Slip> all{
        {2.0 * right, translatable("this is 2θp, the angle on the circle: the element turns by half of it")},
        {-right, sense_turned(e)},
        {right + 90.0, translatable("this is the second direction, square to the first")},
        {right + 45.0, shear_direction(e)},
        {right - 45.0, shear_direction(e)},
        {0.5 * std::atan2(0.5 * xy, a) / degree, is_inertia(e.topic)
                                                     ? translatable("tan 2θp is −Ixy over half the difference")
                                                     : translatable("tan 2θp is the shear over half the difference")}};
    if (is_strain(e.topic)) all.push_back({0.5 * std::atan2(2.0 * xy, a) / degree, whole_gamma});
    return all;
}

std::vector<Slip> turned_slips(Asked asked, const Exercise& e, const Numbers& n)
{
    const Plane p(e, n);
    const double twice = 2.0 * p.once;
    if (asked == Normal)
        return {{n[Centre] + p.along(p.once), once_for_twice},
                {n[Centre] + p.along(twice, -1.0), sense_turned(e)},
                {n[Centre] - p.along(twice), is_inertia(e.topic)
                                                 ? translatable("this is the moment about the axis square to it")
                                                 : translatable("this acts on the plane square to it")},
                {p.along(twice), no_centre}};
    const double k = is_strain(e.topic) ? 2.0 : is_inertia(e.topic) ? -1.0 : 1.0;
    std::vector<Slip> all;
    if (is_strain(e.topic))
        all.push_back({p.across(twice), translatable("this is γ/2, what the circle counts; γ itself is asked")});
    all.insert(all.end(), {{k * p.across(p.once), once_for_twice},
                           {-k * p.across(twice), shear_sign_turned(e)},
                           {k * p.across(twice, -1.0), sense_turned(e)},
                           {k * (p.across(twice) - p.half() * std::sin(twice)), difference_not_halved}});
    return all;
}

std::vector<Slip> third_slips(const Exercise& e, const Numbers& n)
{
    const double right = answer_from(Third, e, n);
    if (e.topic == ExerciseTopic::PlaneStrain)
        return {{0.0, translatable("that is so in plane stress: here the strain is 0, and the stress holds it so")},
                {-right, sign_turned},
                {e.state.x + e.state.y, translatable("Poisson's ratio is left out")},
                {0.5 * right, translatable("the sum is halved: here it is not")}};
    return {{0.0, translatable("the surface is free: its stress is 0, not its strain")},
            {-right, sign_turned},
            {-e.nu * (n[First] + n[Second]), translatable("the division by 1 − ν is missing")}};
}

std::vector<Slip> stress_slips(Asked asked, const Exercise& e, const Numbers& n)
{
    const double own = asked == StressFirst ? n[First] : n[Second], other = asked == StressFirst ? n[Second] : n[First];
    const double E = 1e-3 * e.E, below = 1.0 - e.nu * e.nu;
    return {{E * own, translatable("this is Eε: the strain across counts too, by Poisson's ratio")},
            {E * (own + e.nu * other), translatable("1 − ν² below is missing")},
            {E * (own - e.nu * other) / below, translatable("the sign of ν is that of strains from stresses")},
            {E * (own - e.nu * other), translatable("the sign of ν is that of strains from stresses")},
            {E * (other + e.nu * own) / below, translatable("this is the other principal stress")},
            {E / (1.0 + e.nu) * own, translatable("this is 2Gε: the strain across counts too")}};
}

} // namespace

std::vector<Slip> slips(Asked asked, const Exercise& e, const Numbers& n)
{
    switch (asked) {
    case StrainX:
    case StrainY:
    case ShearStrain: return rosette_slips(asked, e);
    case Centre:
    case Radius:
    case First:
    case Second: return circle_slips(asked, e, n);
    case Direction: return direction_slips(e, n);
    case Normal:
    case Shear: return turned_slips(asked, e, n);
    case LargestShearStrain:
        return {{n[Radius], translatable("this is γ/2, what the circle counts; γ itself is asked")}};
    case Third: return third_slips(e, n);
    case StressFirst:
    case StressSecond: return stress_slips(asked, e, n);
    default: return space_slips(asked, e, n);
    }
}

} // namespace mohr
