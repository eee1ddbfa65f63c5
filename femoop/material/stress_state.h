#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace femoop {

/// Components of stress and strain, tension and elongation positive. xy acts along +y on the face whose normal is +x;
/// as a strain it is the whole loss of the right angle, gamma.
enum class StressComponent : std::uint8_t { x, y, z, xy, yz, zx };
inline constexpr std::size_t n_stress_components = 6;

std::string_view name(StressComponent component);        ///< "sx" ... "tzx"
std::string_view strain_name(StressComponent component); ///< "ex" ... "gzx"

/// What a continuum's points are held to, and the components that are then left to know, in the order of vectors.
///
///   PlaneStress   x y xy            a thin sheet: sz = 0
///   PlaneStrain   x y z xy          a slice of a long body: ez = 0, while sz is not
///   Axisymmetric  x y z xy          a body of revolution about y: x radial, y axial, z hoop
///   Solid         x y z xy yz zx
enum class StressState : std::uint8_t { PlaneStress, PlaneStrain, Axisymmetric, Solid };

std::span<const StressComponent> components(StressState state);
constexpr int n_components(StressState state)
{
    switch (state) {
    case StressState::PlaneStress: return 3;
    case StressState::PlaneStrain:
    case StressState::Axisymmetric: return 4;
    case StressState::Solid: break;
    }
    return 6;
}

} // namespace femoop
