#pragma once

#include "femoop/methods/mohr/space_state.h"

namespace femoop::mohr {

/// A linear elastic, isotropic material.
struct Elasticity {
    double E = 0.0;  ///< in the unit of the stresses, greater than 0
    double nu = 0.0; ///< Poisson's ratio, greater than -1, at most 0.5; less than 0.5 where strains become stresses
};

/// The component square to the plane in plane strain: nu (x + y) of a stress.
double plane_strain_third(const PlaneState& stress, double nu);
/// The strain square to a free surface: -nu (ex + ey) / (1 - nu).
double free_surface_third(const PlaneState& strain, double nu);

/// Stress on a free surface (z = 0) from the strains in it. xy of both is the tensor's: gamma / 2 and tau.
///     sx = E (ex + nu ey) / (1 - nu^2),   tau = E gamma / 2 (1 + nu)
/// Source  [TimoshenkoGoodier1970], Hooke's law, plane stress
PlaneState plane_stress(const PlaneState& strain, const Elasticity& material);

/// Stress from strain in space; \pre nu < 0.5
SpaceState stress(const SpaceState& strain, const Elasticity& material);

} // namespace femoop::mohr
