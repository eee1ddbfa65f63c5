#pragma once

#include <optional>

#include "femoop/model/property.h"
#include "femoop/model/quantity/units.h"

namespace femoop {

/// What a cross-section brings to a member, in one consistent unit of length, about its centroid.
///
///      y'        Looking along +x', y' is up and z' points right.
///      |         Iz, Wz, Asy   bending and shear in the x'y' plane (a rolled beam's strong axis)
///      o--- z'   Iy, Wy, Asz   bending and shear in the x'z' plane
///
/// An inertia that the section does not give is 0; `check` has seen to it that the analysis at hand needs it not.
struct SectionProperties {
    double A = 0.0;              ///< area
    double Iy = 0.0;             ///< integral of z'^2
    double Iz = 0.0;             ///< integral of y'^2
    double J = 0.0;              ///< Saint-Venant's torsion constant
    double Iyz = 0.0;            ///< integral of y' z'; only `l` and L have one, and the analysis leaves it out
    std::optional<double> Asy{}; ///< shear area for Vy; absent: no shear strain in the x'y' plane
    std::optional<double> Asz{}; ///< shear area for Vz; absent: no shear strain in the x'z' plane
    std::optional<double> h{};   ///< depth along y'
    std::optional<double> yc{};  ///< centroid's distance from the -y' fibre
    std::optional<double> b{};   ///< width along z'
    std::optional<double> zc{};  ///< centroid's distance from the -z' fibre
    std::optional<double> Wy{};  ///< elastic modulus Iy / z'max; absent where the width is unknown
    std::optional<double> Wz{};  ///< elastic modulus Iz / y'max; absent where the depth is unknown
};

/// Properties of a shape, all straight edges and no fillets, in the unit of its dimensions.
///
///     rectangle   circle   tube     box        i          t          l          c
///     +---+        ___     ___    +-----+   =======    =======    |          +=====
///     |   |       /   \   / _ \   | +-+ |      |          |       |          |
///     |   | h     |   |   |( )|   | | | |      |          |       | h        |       h
///     |   |       \___/   \___/   | +-+ |      |          |       |          |
///     +---+         d      d t    +-----+   =======       |       +=====     +=====
///       b                            t         bf         h          b          bf
///
/// h lies along y'. t has its flange at the top (+y'); l its corner at (-y', -z'), like the letter; c its web at
/// -z', like the letter.
///
/// Exact     A, Iy, Iz, Iyz, yc; J of circle and tube; J of the rectangle by Saint-Venant's series, to 1e-12:
///           J = a c^3 (1/3 - 64 c / (pi^5 a) sum_{n odd} tanh(n pi a / 2 c) / n^5), a >= c its sides
/// J         box: Bredt, 4 Am^2 / (integral of ds/t) on the mid-line; i t l c: sum l t^3 / 3 over their rectangles
/// Shear     rectangle 5A/6, circle 9A/10, tube A/2; box 2 h t and 2 b t; i t c: web h tw for y', flanges
///           5/6 sum bf tf for z'; l: 5/6 of each leg, h t for y' and b t for z'
/// Source    [TimoshenkoGoodier1970], section 109 (rectangle), 112 (rolled sections),
///           116 (thin tubes); [GereTimoshenko], form factors for shear
/// Reference courseware/reference/sections.md
/// \pre      `why_not(shape)` (femoop/section/shape.h) has nothing to say.
/// \throws   std::invalid_argument with that reason.
SectionProperties shape_properties(const SectionShape& shape);

/// What the section brings when it is turned by 90 degrees counter-clockwise, its top to -z' and its right side to the
/// top: the properties of the two axes change places, Iyz its sign.
SectionProperties turned(const SectionProperties& upright);

/// Properties of a model's section in the model's base units: those of its shape or profile, turned where it is, then
/// overridden by what the section itself gives. yc is h/2 where nothing else is known; a given h without yc keeps the shape's yc / h.
/// An overridden Iz or Iy drops the modulus of the shape or profile that belonged to it.
/// \throws std::invalid_argument for a shape that cannot be or a profile that no table has (`check` reports both).
SectionProperties section_properties(const Section& section, const Units& units);

} // namespace femoop
