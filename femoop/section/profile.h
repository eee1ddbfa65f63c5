#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "femoop/model/quantity/units.h"

namespace femoop {

/// Families of hot-rolled profiles.
enum class ProfileFamily : std::uint8_t { IPE, HEA, HEB, HEM, UPN, W };

/// A hot-rolled profile as its standard publishes it, in the table's own unit of length.
///
///            bf                              bf
///       |<-------->|                     |<----->|
///       ============ tf       y'         +======== tf
///            ||               |          ||
///        tw  ||   h           o--- z'    || tw      h
///            ||r                         ||r
///       ============                     +========
///     IPE HEA HEB HEM W                     UPN (flanges taper, tf is their nominal thickness)
///
/// In a member's axes: the web lies along y', so Iz is the strong axis (y-y in EN 10365, x-x in the AISC tables).
/// Shear areas (of section_properties): h tw for y', 5/6 of both flanges for z', as of the shapes `i` and `c`.
struct Profile {
    std::string_view name; ///< without blanks: "IPE300", "W12X26"
    ProfileFamily family = ProfileFamily::IPE;
    LengthUnit unit = LengthUnit::cm; ///< of all that follows; inches for W
    double h = 0.0, bf = 0.0, tf = 0.0, tw = 0.0;
    double r = 0.0;    ///< root radius; for W the design k less tf
    double A = 0.0;    ///< area
    double Iz = 0.0;   ///< strong axis
    double Wz = 0.0;   ///< elastic modulus, strong axis
    double Zz = 0.0;   ///< plastic modulus, strong axis
    double Iy = 0.0;   ///< weak axis
    double Wy = 0.0;   ///< elastic modulus, weak axis
    double Zy = 0.0;   ///< plastic modulus, weak axis
    double J = 0.0;    ///< torsion constant
    double zc = 0.0;   ///< centroid's distance from the -z' side: bf/2, but for UPN from the back of the web
    double mass = 0.0; ///< [kg/m], whatever `unit` is
};

/// The profile of that name, or nullptr. Case and blanks do not matter, x may be written as a multiplication sign,
/// and EN 10365's own "HE 300 A" finds HEA300.
/// Source  [EN10365] (IPE, HEA, HEB, HEM, UPN), [AiscShapes16] (W)
const Profile* find_profile(std::string_view name);

std::span<const Profile> profiles();                     ///< every profile, family by family
std::span<const Profile> profiles(ProfileFamily family); ///< in the standard's order
std::span<const ProfileFamily> profile_families();
std::string_view name(ProfileFamily family);     ///< "IPE"
std::string_view standard(ProfileFamily family); ///< "EN 10365:2017"

} // namespace femoop
