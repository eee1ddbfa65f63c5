#include "femoop/methods/mohr/state.h"

#include <cmath>

namespace femoop::mohr {

namespace {

double third(const State& state)
{
    if (state.kind == Kind::PlaneStrain) return plane_strain_third(plane(state), state.nu.value_or(0.0));
    if (state.kind == Kind::Strain && state.nu) return free_surface_third(plane(state), *state.nu);
    return 0.0;
}

} // namespace

bool is_plane(Kind kind) { return kind != Kind::SpaceStress && kind != Kind::SpaceStrain; }
bool is_strain(Kind kind) { return kind == Kind::Strain || kind == Kind::SpaceStrain; }
bool is_stress(Kind kind) { return !is_strain(kind) && kind != Kind::Inertia; }

PlaneState plane(const State& state) { return {state.components.x, state.components.y, state.components.xy}; }

std::optional<SpaceState> in_space(const State& state)
{
    if (state.kind == Kind::Inertia) return std::nullopt;
    return is_plane(state.kind) ? in_space(plane(state), third(state)) : state.components;
}

std::optional<SpaceState> stress(const State& state)
{
    if (is_stress(state.kind)) return in_space(state);
    if (!is_strain(state.kind) || !state.E || !state.nu) return std::nullopt;
    const Elasticity material{*state.E, *state.nu};
    if (state.kind == Kind::Strain) return in_space(plane_stress(plane(state), material), 0.0);
    return stress(state.components, material);
}

State plane_state(Kind kind, double x, double y, double xy)
{
    const double component = kind == Kind::Strain ? 0.5 * xy : kind == Kind::Inertia ? -xy : xy;
    return {.kind = kind, .components = {.x = x, .y = y, .xy = component + 0.0}};
}

double given_shear(Kind kind, double xy)
{
    return (is_strain(kind) ? 2.0 * xy : kind == Kind::Inertia ? -xy : xy) + 0.0;
}

bool is_possible(const State& state)
{
    constexpr double rounding = 1e-9; // of the larger principal value
    if (state.kind != Kind::Inertia) return true;
    const PlanePrincipal p = principal(plane(state));
    return p.second >= -rounding * std::abs(p.first);
}

} // namespace femoop::mohr
