#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "femoop/methods/mohr/space_state.h"

namespace femoop::mohr {

/// When a material fails, by the principal stresses s1 >= s2 >= s3, tension positive.
enum class Criterion : std::uint8_t {
    Tresca,        ///< s1 - s3 = fy
    VonMises,      ///< sqrt(3 J2) = fy
    Rankine,       ///< s1 = ft or -s3 = fc
    MohrCoulomb,   ///< |tau| = c - s tan(phi):  (s1 - s3)/2 + (s1 + s3)/2 sin(phi) = c cos(phi)
    DruckerPrager, ///< sqrt(J2) + a I1 = k through Mohr-Coulomb's corners of axial compression:
                   ///< a = 2 sin(phi) / (sqrt(3) (3 - sin(phi))), k = 6 c cos(phi) / (sqrt(3) (3 - sin(phi)))
    HoekBrown      ///< of rock, compression positive: p1 = p3 + sqrt(m sci p3 + s sci^2), p1 = -s3, p3 = -s1
};

/// Strengths of a material, in the unit of its stresses. A criterion reads its own alone.
/// Source  [ChenHan1988], [HoekBrown1980]
struct Strength {
    double fy = 0.0;         ///< Tresca, von Mises: yield in tension, > 0
    double ft = 0.0;         ///< Rankine: in tension, > 0
    double fc = 0.0;         ///< Rankine: in compression, > 0
    double c = 0.0;          ///< Mohr-Coulomb, Drucker-Prager: cohesion, > 0
    double phi = 0.0;        ///< likewise: angle of friction [rad], 0 <= phi < pi/2
    double sci = 0.0;        ///< Hoek-Brown: axial compressive strength of the intact rock, > 0
    double m = 0.0, s = 0.0; ///< Hoek-Brown: m > 0, 0 < s <= 1
};

/// What is wrong with a strength: the criterion cannot use it.
enum class StrengthFlaw : std::uint8_t { NotPositive, AngleOutOfRange, AboveOne };
struct StrengthFault {
    StrengthFlaw flaw;
    double Strength::*value; ///< which
};
std::optional<StrengthFault> why_not(Criterion criterion, const Strength& strength);
std::optional<StrengthFlaw> why_not(double Strength::*which, double value); ///< of one alone

/// How far a stress is from failure if all of it grows in proportion.
struct Safety {
    /// What the stress must be multiplied by to fail: less than 1 has failed. Absent: it never fails that way.
    std::optional<double> factor{};
    /// Unit normals of planes that fail, in x, y, z: where the largest circle touches the envelope (two of them), the
    /// plane of the largest tension or compression (one), or octahedral planes for a criterion of energy (one of the
    /// four).
    std::vector<Eigen::Vector3d> planes{};
};
/// \pre `why_not` has nothing to say
Safety safety(Criterion criterion, const Strength& strength, const SpacePrincipal& stress);

/// A line in the plane of normal stress and size of shear.
using Curve = std::vector<CirclePoint>;

/// What no circle of a stress may cross, above the axis, between the normal stresses `from` and `to`. Of Tresca,
/// Rankine, Mohr-Coulomb and Hoek-Brown it bounds the largest circle of any stress; of von Mises and Drucker-Prager the
/// circle in the plane of a stress whose third component is z = share (x + y): share is 0 of a plane stress, Poisson's
/// ratio of a plane strain (locus.h has what bounds the others). Empty where it has no part there.
std::vector<Curve> envelope(Criterion criterion, const Strength& strength, double from, double to, double share = 0.0);

} // namespace femoop::mohr
