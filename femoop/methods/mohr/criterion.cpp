#include "femoop/methods/mohr/criterion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "femoop/methods/mohr/criterion_names.h"
#include "femoop/methods/mohr/rounding.h"

namespace femoop::mohr {

namespace {

using std::numbers::pi;
constexpr double sqrt3 = std::numbers::sqrt3;

bool is_positive(double value) { return std::isfinite(value) && value > 0.0; }

std::optional<double> safety_ratio(double strength, double demand)
{
    if (!(demand > 0.0)) return std::nullopt;
    const double factor = strength / demand;
    return std::isfinite(factor) ? std::optional(factor) : std::nullopt;
}

std::optional<double> lesser(std::optional<double> a, std::optional<double> b)
{
    if (!a || !b) return a ? a : b;
    return std::min(*a, *b);
}

/// Of a unit vector.
Eigen::Vector3d without_negative_zeros(const Eigen::Vector3d& v)
{
    return v.unaryExpr([](double part) { return without_rounding(part, 1.0); });
}

/// The two planes whose normals lie at `angle` from the first direction, in the plane of the first and the third.
std::vector<Eigen::Vector3d> planes_at(const SpacePrincipal& stress, double angle)
{
    const Eigen::Vector3d first = stress.directions.col(0), third = stress.directions.col(2);
    const Eigen::Vector3d along = std::cos(angle) * first, across = std::sin(angle) * third;
    return {without_negative_zeros(along + across), without_negative_zeros(along - across)};
}

std::vector<Eigen::Vector3d> octahedral_plane(const SpacePrincipal& stress)
{
    return {without_negative_zeros(stress.directions * Eigen::Vector3d::Ones().normalized())};
}

struct Cone {
    double a = 0.0, k = 0.0;
};
Cone drucker_prager(const Strength& strength)
{
    const double sin = std::sin(strength.phi), below = sqrt3 * (3.0 - sin);
    return {2.0 * sin / below, 6.0 * strength.c * std::cos(strength.phi) / below};
}

/// p1 - p3 at failure of Hoek and Brown; compression positive.
double hoek_brown_reach(const Strength& k, double p3)
{
    return std::sqrt(std::max(0.0, k.m * k.sci * p3 + k.s * k.sci * k.sci));
}

/// sin of the slope of the envelope where the circle of `p3` touches it, from dp1/dp3.
double hoek_brown_slope(const Strength& k, double p3)
{
    const double reach = hoek_brown_reach(k, p3);
    return reach > 0.0 ? k.m * k.sci / (4.0 * reach + k.m * k.sci) : 1.0;
}

/// The multiple k with k d = sqrt(m sci k p3 + s sci^2), d = p1 - p3.
std::optional<double> hoek_brown_factor(const Strength& k, double p1, double p3)
{
    const double d = sum_of({p1, -p3}), b = k.m * k.sci * p3, c = k.s * k.sci * k.sci;
    const double root = std::hypot(b, 2.0 * d * std::sqrt(c));
    // Of the two forms of the root the one without cancellation.
    if (b <= 0.0) return safety_ratio(2.0 * c, root - b);
    return safety_ratio(b + root, 2.0 * d * d);
}

Safety hoek_brown(const Strength& strength, const SpacePrincipal& stress)
{
    const double p1 = -stress.values[2], p3 = -stress.values[0];
    const auto factor = hoek_brown_factor(strength, p1, p3);
    if (!factor) return {};
    const double slope = std::asin(hoek_brown_slope(strength, *factor * p3));
    return {factor, planes_at(stress, 0.25 * pi - 0.5 * slope)};
}

Safety rankine(const Strength& strength, const SpacePrincipal& stress)
{
    const auto tension = safety_ratio(strength.ft, stress.values[0]),
               compression = safety_ratio(strength.fc, -stress.values[2]);
    const auto factor = lesser(tension, compression);
    if (!factor) return {};
    return {factor, {stress.directions.col(factor == tension ? 0 : 2)}};
}

Safety mohr_coulomb(const Strength& strength, const SpacePrincipal& stress)
{
    const auto [centre, radius] = circles(stress)[0];
    const auto factor = safety_ratio(strength.c * std::cos(strength.phi),
                                     sum_of({radius, centre * std::sin(strength.phi)}));
    if (!factor) return {};
    return {factor, planes_at(stress, 0.25 * pi - 0.5 * strength.phi)};
}

Safety of_energy(std::optional<double> factor, const SpacePrincipal& stress)
{
    return factor ? Safety{factor, octahedral_plane(stress)} : Safety{};
}

/// The touching points of a family of circles of radius r(centre), above the axis: an envelope.
struct Touch {
    double centre, radius, slope; ///< slope = dr/dcentre
};
void add_touch(Curve& curve, const Touch& t)
{
    if (!(t.radius >= 0.0) || std::abs(t.slope) > 1.0) return;
    curve.push_back({t.centre - t.radius * t.slope, t.radius * std::sqrt(1.0 - t.slope * t.slope)});
}

constexpr int n_pieces = 96;

/// An ellipse by its middle and its half axes along both, the half above the axis.
Curve half_ellipse(double middle, double along, double up)
{
    Curve curve;
    for (int i = 0; i <= n_pieces; ++i) {
        const double t = pi * i / n_pieces;
        curve.push_back({middle - along * std::cos(t), up * std::sin(t)});
    }
    return curve;
}

/// The circles of centre c and radius r with s3 = 2 share c and 3 r^2 + (1 - 2 share)^2 c^2 = fy^2 touch an ellipse; of
/// share 1/2 two lines.
Curve von_mises_envelope(double fy, double from, double to, double share)
{
    const double k = 1.0 - 2.0 * share, up = fy / sqrt3;
    if (std::abs(k) < 1e-9) return {{from, up}, {to, up}};
    return half_ellipse(0.0, fy * std::sqrt(1.0 + k * k / 3.0) / std::abs(k), up);
}

/// Circles on Drucker and Prager's cone: r^2 + (1 - 2 share)^2 c^2/3 = (k - 2 (1 + share) a c)^2.
std::vector<Curve> drucker_prager_envelope(const Strength& strength, double from, double to, double share)
{
    const auto [a, k] = drucker_prager(strength);
    const double flat = (1.0 - 2.0 * share) * (1.0 - 2.0 * share) / 3.0, slope = 2.0 * (1.0 + share) * a;
    Curve curve;
    const double reach = to - from;
    for (int i = 0; i <= 4 * n_pieces; ++i) {
        const double c = from - reach + 3.0 * reach * i / (4 * n_pieces);
        const double side = k - slope * c, square = side * side - flat * c * c;
        if (side < 0.0 || square <= 0.0) continue;
        const double r = std::sqrt(square);
        add_touch(curve, {c, r, (-slope * side - flat * c) / r});
    }
    return {curve};
}

std::vector<Curve> hoek_brown_envelope(const Strength& strength, double from, double to)
{
    const double apex = strength.s * strength.sci / strength.m; // tension that fails without any shear
    Curve curve;
    const double most = std::max(0.0, -from) + 2.0 * (to - from) + apex; // p3 up to there
    for (int i = 0; i <= n_pieces; ++i) {
        const double share = static_cast<double>(i) / n_pieces;
        const double p3 = -apex + most * share * share; // closer where it bends
        const double reach = hoek_brown_reach(strength, p3), slope = hoek_brown_slope(strength, p3);
        add_touch(curve, {-(p3 + 0.5 * reach), 0.5 * reach, -slope});
    }
    return {curve};
}

Curve mohr_coulomb_line(const Strength& strength, double from, double to)
{
    const double slope = std::tan(strength.phi);
    const double end = slope > 0.0 ? std::min(to, strength.c / slope) : to;
    if (end < from) return {};
    return {{from, strength.c - from * slope}, {end, strength.c - end * slope}};
}

} // namespace

std::optional<StrengthFlaw> why_not(double Strength::*which, double value)
{
    if (which == &Strength::phi) {
        const bool is_sharp = value >= 0.0 && value < 0.5 * pi;
        return is_sharp ? std::nullopt : std::optional(StrengthFlaw::AngleOutOfRange);
    }
    if (which == &Strength::s && value > 1.0) return StrengthFlaw::AboveOne;
    return is_positive(value) ? std::nullopt : std::optional(StrengthFlaw::NotPositive);
}

std::optional<StrengthFault> why_not(Criterion criterion, const Strength& strength)
{
    for (const StrengthName& name : strengths_of(criterion))
        if (const auto flaw = why_not(name.value, strength.*name.value)) return StrengthFault{*flaw, name.value};
    return std::nullopt;
}

Safety safety(Criterion criterion, const Strength& strength, const SpacePrincipal& stress)
{
    switch (criterion) {
    case Criterion::Tresca: {
        const auto factor = safety_ratio(strength.fy, 2.0 * absolute_largest_shear(stress));
        return factor ? Safety{factor, planes_at(stress, 0.25 * pi)} : Safety{};
    }
    case Criterion::VonMises: return of_energy(safety_ratio(strength.fy, deviator(stress).equivalent), stress);
    case Criterion::Rankine: return rankine(strength, stress);
    case Criterion::MohrCoulomb: return mohr_coulomb(strength, stress);
    case Criterion::DruckerPrager: {
        const Deviator d = deviator(stress);
        const auto [a, k] = drucker_prager(strength);
        return of_energy(safety_ratio(k, sum_of({d.equivalent / sqrt3, 3.0 * a * d.mean})), stress);
    }
    case Criterion::HoekBrown: return hoek_brown(strength, stress);
    }
    return {};
}

std::vector<Curve> envelope(Criterion criterion, const Strength& strength, double from, double to, double share)
{
    const double high = 2.0 * (to - from);
    switch (criterion) {
    case Criterion::Tresca: return {{{from, 0.5 * strength.fy}, {to, 0.5 * strength.fy}}};
    case Criterion::VonMises: return {von_mises_envelope(strength.fy, from, to, share)};
    case Criterion::Rankine:
        return {{{strength.ft, 0.0}, {strength.ft, high}}, {{-strength.fc, 0.0}, {-strength.fc, high}}};
    case Criterion::MohrCoulomb: return {mohr_coulomb_line(strength, from, to)};
    case Criterion::DruckerPrager: return drucker_prager_envelope(strength, from, to, share);
    case Criterion::HoekBrown: return hoek_brown_envelope(strength, from, to);
    }
    return {};
}

} // namespace femoop::mohr
