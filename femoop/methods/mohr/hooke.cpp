#include "femoop/methods/mohr/hooke.h"

#include "femoop/methods/mohr/rounding.h"

namespace femoop::mohr {

double plane_strain_third(const PlaneState& stress, double nu) { return nu * sum_of({stress.x, stress.y}) + 0.0; }

double free_surface_third(const PlaneState& strain, double nu)
{
    return -nu / (1.0 - nu) * sum_of({strain.x, strain.y}) + 0.0;
}

PlaneState plane_stress(const PlaneState& e, const Elasticity& material)
{
    const auto [E, nu] = material;
    const double k = E / (1.0 - nu * nu);
    return {k * sum_of({e.x, nu * e.y}), k * sum_of({e.y, nu * e.x}), E / (1.0 + nu) * e.xy};
}

SpaceState stress(const SpaceState& e, const Elasticity& material)
{
    const auto [E, nu] = material;
    const double two_G = E / (1.0 + nu);
    const double share = nu / (1.0 - 2.0 * nu);
    const auto normal = [&](double own) { return two_G * sum_of({own, share * e.x, share * e.y, share * e.z}); };
    return {normal(e.x), normal(e.y), normal(e.z), two_G * e.xy, two_G * e.yz, two_G * e.zx};
}

} // namespace femoop::mohr
