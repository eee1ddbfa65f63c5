#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "femoop/model/quantity/units.h"

namespace femoop {

/// Families of hot-rolled profiles. W is the American table in inches, WMetric and HPMetric the Brazilian ones.
enum class ProfileFamily : std::uint8_t { IPE, HEA, HEB, HEM, UPN, W, WMetric, HPMetric, L, CHS, SHS, RHS };

/// A hot-rolled profile in its table's own unit of length, as its standard publishes it; of L, CHS, SHS and RHS the
/// standard's dimensions, from which the rest is calculated: exactly, but for J of L and of SHS and RHS.
///
///            bf                              bf
///       |<-------->|                     |<----->|
///       ============ tf       y'         +======== tf
///            ||               |          ||
///        tw  ||   h           o--- z'    || tw      h
///            ||r                         ||r
///       ============                     +========
///     IPE HEA HEB HEM W HP                  UPN (flanges taper, tf is their nominal thickness)
///
///       ..  rounded r/2                     .---------.  rounded r = 1.5 t outside, t inside
///       ||       y'                         | .-----. |
///       ||       |                          | |     | |
///       ||  h    o--- z'                    | |     | |  h     CHS: a ring, h = bf its diameter
///       || r                                | |     | |
///       ==========.                         | .-----. |
///       |<- bf -->|  tf = tw = t            .---------.  bf, tf = tw = t
///          L                                  SHS RHS
///
/// In a member's axes: the web lies along y', so Iz is the strong axis (y-y in EN 10365, x-x in the AISC tables).
/// Shear areas (of section_properties) are those of the shapes `i`, `c`, `l`, `tube` and `box`.
/// J of L is El Darwish and Johnston's, (h + bf - t) t^3 / 3 - 0.21 t^4 + alpha D^4 with D the circle inscribed at the
/// corner; of SHS and RHS that of EN 10210-2, t^3 s / 3 + 4 Am^2 t / s with s the length of the wall's mid-line.
struct Profile {
    std::string_view name; ///< without blanks: "IPE300", "W12X26"
    ProfileFamily family = ProfileFamily::IPE;
    LengthUnit unit = LengthUnit::cm; ///< of all that follows; inches for W
    double h = 0.0, bf = 0.0, tf = 0.0, tw = 0.0;
    double r = 0.0;    ///< root radius, for W the design k less tf; of SHS and RHS the outer corner's
    double A = 0.0;    ///< area
    double Iz = 0.0;   ///< strong axis
    double Wz = 0.0;   ///< elastic modulus, strong axis
    double Zz = 0.0;   ///< plastic modulus, strong axis; of L not known, 0
    double Iy = 0.0;   ///< weak axis
    double Wy = 0.0;   ///< elastic modulus, weak axis
    double Zy = 0.0;   ///< plastic modulus, weak axis; of L not known, 0
    double J = 0.0;    ///< torsion constant
    double zc = 0.0;   ///< centroid's distance from the -z' side: bf/2, but for UPN and L from the back
    double yc = 0.0;   ///< centroid's distance from the -y' side: h/2, but for L from the back
    double Iyz = 0.0;  ///< product of inertia; only L has one
    double mass = 0.0; ///< [kg/m], whatever `unit` is; of CHS, SHS and RHS 7850 kg/m^3 times A
};

/// The profile of that name, or nullptr. Case and blanks do not matter, x may be written as a multiplication sign, a
/// decimal point as a comma. EN 10365's own "HE 300 A" finds HEA300, Gerdau's "W 150 x 22,5 (H)" finds W150X22.5,
/// "W 150 x 13,0" W150X13, and one width stands for two equal ones: "L 100x10" is L100X100X10, likewise of SHS.
/// Source  [EN10365] (IPE, HEA, HEB, HEM, UPN), [AiscShapes16] (W), [GerdauPerfis] and [NBR15980] (WMetric, HPMetric),
///         [EN10056-1] (L), [EN10210-2] (CHS, SHS, RHS), [ElDarwishJohnston1965] (J of L)
const Profile* find_profile(std::string_view name);
/// Of a name that no profile has, so many names at the most that may be meant: of the same kind, whose names begin with
/// the same letters, those of about the same sizes, the nearest first; where there are none, those that are a slip or two
/// away, and only then such ones of other kinds.
std::vector<std::string_view> near_profiles(std::string_view name, std::size_t most);

std::span<const Profile> profiles();                     ///< every profile, family by family
std::span<const Profile> profiles(ProfileFamily family); ///< in the standard's order
std::span<const ProfileFamily> profile_families();
std::string_view name(ProfileFamily family);     ///< "IPE"; "W BR" of the Brazilian W
std::string_view standard(ProfileFamily family); ///< "EN 10365:2017"

} // namespace femoop
