#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "femoop/methods/mohr/hooke.h"

namespace femoop::mohr {

enum class Kind : std::uint8_t {
    PlaneStress, ///< z = zx = yz = 0
    PlaneStrain, ///< a stress with z = nu (x + y), zx = yz = 0
    Strain,      ///< plane: z = 0, or of a free surface where nu is given
    Inertia,     ///< second moments of area; no third direction
    SpaceStress,
    SpaceStrain
};

/// What stands at a point: the components in x, y, z, and what they are components of.
struct State {
    Kind kind = Kind::PlaneStress;
    SpaceState components{};    ///< a plane kind has x, y and xy alone
    std::optional<double> nu{}; ///< PlaneStrain needs it, Strain may have it
    std::optional<double> E{};  ///< with nu, stresses follow from strains

    friend bool operator==(const State&, const State&) = default;
};

bool is_plane(Kind kind);
bool is_strain(Kind kind);
bool is_stress(Kind kind);

PlaneState plane(const State& state); ///< x, y, xy
/// The tensor with its third direction; absent for a second moment of area.
std::optional<SpaceState> in_space(const State& state);
/// The stresses of a strain whose E and nu are given, or of a stress itself; nu < 0.5 for SpaceStrain.
std::optional<SpaceState> stress(const State& state);

/// A state of a plane kind from numbers as they are given: gamma_xy of a strain, Ixy of second moments of area.
State plane_state(Kind kind, double x, double y, double xy);
/// False of second moments that no section has: a principal one would be negative, Ix < 0, Iy < 0 or Ixy^2 > Ix Iy.
bool is_possible(const State& state);
/// What `xy` is called outside: tau_xy, gamma_xy = 2 xy, Ixy = -xy.
double given_shear(Kind kind, double xy);

} // namespace femoop::mohr
