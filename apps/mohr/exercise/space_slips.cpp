#include "apps/mohr/exercise/space_slips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "apps/mohr/exercise/slip_words.h"
#include "ui/text/catalogue.h"

namespace mohr {

namespace fm = femoop::mohr;
using enum Asked;
using ui::translatable;

namespace {

constexpr auto upside_down = translatable("it is upside down: the strength is divided by what acts");
constexpr auto not_in_order = translatable(
    "the order is another: σ1 is the largest and σ3 the smallest, with their signs");

std::vector<Slip> invariant_slips(Asked asked, const Exercise& e)
{
    const auto& s = e.space;
    const double minors = s.x * s.y + s.y * s.z + s.z * s.x, shears = s.xy * s.xy + s.yz * s.yz + s.zx * s.zx;
    const double product = s.x * s.y * s.z, mixed = 2.0 * s.xy * s.yz * s.zx;
    const double across = s.x * s.yz * s.yz + s.y * s.zx * s.zx + s.z * s.xy * s.xy;
    constexpr auto no_shear = translatable("the shear is left out");
    constexpr auto shear_sign = translatable("the squares of the shears are added: they are taken off");
    if (asked == I1) return {{(s.x + s.y + s.z) / 3.0, translatable("this is the mean: I1 is the sum")}};
    if (asked == I2) return {{minors, no_shear}, {minors + shears, shear_sign}, {shears - minors, sign_turned}};
    return {{product, no_shear},
            {product + mixed + across, shear_sign},
            {product - across, translatable("twice the product of the three shears is missing")},
            {product + 0.5 * mixed - across,
             translatable("the product of the three shears is counted once: it counts twice")},
            {across - mixed - product, sign_turned}};
}

std::vector<Slip> space_value_slips(const Numbers& n)
{
    return {{n[SpaceFirst], not_in_order}, {n[SpaceSecond], not_in_order}, {n[SpaceThird], not_in_order}};
}

/// Largest, middle, least.
std::array<double, 3> in_order(const Exercise& e, const Numbers& n)
{
    if (e.topic == ExerciseTopic::Space) return {n[SpaceFirst], n[SpaceSecond], n[SpaceThird]};
    std::array values{n[First], n[Second], n[Third]};
    std::ranges::sort(values, std::greater{});
    return values;
}

std::vector<Slip> largest_shear_slips(const Exercise& e, const Numbers& n)
{
    const auto [s1, s2, s3] = in_order(e, n);
    return {
        {n[Radius],
         translatable("this is the largest shear in the plane: the third principal stress lies outside the circle")},
        {s1 - s3, translatable("the difference of the extreme principal stresses is not halved")},
        {0.5 * (s1 - s2), translatable("this is another circle: the largest lies between the extreme ones")},
        {0.5 * (s2 - s3), translatable("this is another circle: the largest lies between the extreme ones")},
        {0.5 * (s1 + s3), translatable("this is the centre: the shear is half the difference")}};
}

std::vector<Slip> von_mises_slips(const Exercise& e, const Numbers& n)
{
    const auto [s1, s2, s3] = in_order(e, n);
    const double right = answer_from(VonMises, e, n), sq = std::hypot(n[First], n[Second]);
    std::vector<Slip> all{{right * right, no_root},
                          {std::numbers::sqrt2 * right, translatable("the sum of the squares is not halved")},
                          {right / std::numbers::sqrt3, translatable("this is √J2: von Mises' stress is √(3 J2)")},
                          {std::numbers::sqrt2 * right / 3.0, translatable("this is the octahedral shear")},
                          {s1 - s3, translatable("this is Tresca's stress")}};
    if (e.topic != ExerciseTopic::Space) {
        all.push_back(
            {std::sqrt(sq * sq + n[First] * n[Second]), translatable("the product is added: it is taken off, −σ1 σ2")});
        all.push_back({sq, translatable("the product σ1 σ2 is left out")});
    }
    return all;
}

std::vector<Slip> on_plane_slips(Asked asked, const Exercise& e)
{
    const Eigen::Vector3d whole(e.normal[0], e.normal[1], e.normal[2]);
    const fm::OnPlane on = fm::on_plane(e.space, whole);
    constexpr auto no_unit = translatable("the normal has not the length 1");
    if (asked == SpaceNormal)
        return {
            {on.normal_component * whole.squaredNorm(), no_unit},
            {on.normal_component * whole.norm(), no_unit},
            {on.traction.norm(), translatable("this is the size of the traction: its part along the normal is asked")},
            {on.traction.sum(), translatable("the parts of the traction are added: each counts by the normal's")}};
    return {{on.traction.norm(), translatable("this is the size of the traction: its normal part is taken off")},
            {on.shear * on.shear, no_root},
            {on.traction.norm() - std::abs(on.normal_component),
             translatable("the sizes are subtracted: their squares are, as in a right triangle")}};
}

std::vector<Slip> factor_slips(Asked asked, const Exercise& e, const Numbers& n)
{
    const auto [s1, s2, s3] = in_order(e, n);
    const double right = answer_from(asked, e, n);
    const fm::Strength& k = e.strength;
    const double c = 0.5 * (s1 + s3), r = 0.5 * (s1 - s3), sin = std::sin(k.phi), cos = std::cos(k.phi);
    std::vector<Slip> all{{1.0 / right, upside_down}};
    const auto add = [&](std::initializer_list<Slip> more) { all.insert(all.end(), more); };
    constexpr auto one_alone = translatable(
        "this is the greatest principal stress alone, which is Rankine's criterion");
    const double largest = std::max(std::abs(s1), std::abs(s3));
    switch (asked) {
    case FactorTresca:
        add({{k.fy / (n[First] - n[Second]),
              translatable("the third principal stress, 0, is left out: it is the least of the three")},
             {2.0 * right, translatable("fy is compared with the largest shear: it fails at fy/2")},
             {k.fy / largest, one_alone},
             {k.fy / n[VonMises], translatable("this is von Mises' criterion")}});
        break;
    case FactorVonMises:
        add({{k.fy / (s1 - s3), translatable("this is Tresca's criterion")},
             {k.fy / largest, one_alone},
             {right * right, no_root}});
        break;
    case FactorRankine:
        add({{k.ft / s1, translatable("compression governs: compare both strengths")},
             {k.fc / -s3, translatable("tension governs: compare both strengths")},
             {k.fc / s1, translatable("the strengths are taken for one another")},
             {k.ft / -s3, translatable("the strengths are taken for one another")}});
        break;
    default:
        add({{k.c * cos / (r - c * sin), translatable("the sign of friction is turned: tension is positive here")},
             {k.c / (r + c * sin), translatable("the cosine of φ is missing beside c")},
             {k.c / r, translatable("friction is left out")},
             {k.c * cos / r, translatable("friction is left out")},
             {k.c / (r + c * std::tan(k.phi)),
              translatable("the top of the circle is put on the line: the circle touches it aside of the top")}});
    }
    return all;
}

} // namespace

std::vector<Slip> space_slips(Asked asked, const Exercise& e, const Numbers& n)
{
    switch (asked) {
    case I1:
    case I2:
    case I3: return invariant_slips(asked, e);
    case SpaceFirst:
    case SpaceSecond:
    case SpaceThird: return space_value_slips(n);
    case LargestShear: return largest_shear_slips(e, n);
    case Mean: return {{3.0 * n[Mean], translatable("the sum is not divided by three")}};
    case VonMises: return von_mises_slips(e, n);
    case SpaceNormal:
    case SpaceShear: return on_plane_slips(asked, e);
    default: return factor_slips(asked, e, n);
    }
}

} // namespace mohr
