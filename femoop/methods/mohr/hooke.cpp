#include "femoop/methods/mohr/hooke.h"

namespace femoop::mohr {

double plane_strain_third(const PlaneState& stress, double nu) { return nu * (stress.x + stress.y) + 0.0; }

double free_surface_third(const PlaneState& strain, double nu)
{
    return -nu / (1.0 - nu) * (strain.x + strain.y) + 0.0;
}

PlaneState plane_stress(const PlaneState& e, const Elasticity& material)
{
    const auto [E, nu] = material;
    const double k = E / (1.0 - nu * nu);
    return {k * (e.x + nu * e.y), k * (e.y + nu * e.x), E / (1.0 + nu) * e.xy};
}

SpaceState stress(const SpaceState& e, const Elasticity& material)
{
    const auto [E, nu] = material;
    const double two_G = E / (1.0 + nu);
    const double volume = nu / (1.0 - 2.0 * nu) * (e.x + e.y + e.z);
    return {two_G * (e.x + volume), two_G * (e.y + volume), two_G * (e.z + volume),
            two_G * e.xy,           two_G * e.yz,           two_G * e.zx};
}

} // namespace femoop::mohr
