#pragma once

#include "femoop/model/dof.h"
#include "femoop/model/quantity/dimension.h"

namespace femoop {

/// What is counted along or about a degree of freedom: the dimension of its displacement, force, line load, spring,
/// mass.
constexpr Dimension displacement_dimension(Dof dof) { return is_rotation(dof) ? dimension::angle : dimension::length; }
constexpr Dimension force_dimension(Dof dof) { return is_rotation(dof) ? dimension::moment : dimension::force; }
constexpr Dimension line_load_dimension(Dof dof)
{
    return is_rotation(dof) ? dimension::moment_per_length : dimension::force_per_length;
}
constexpr Dimension spring_dimension(Dof dof)
{
    return is_rotation(dof) ? dimension::moment_per_angle : dimension::force_per_length;
}
constexpr Dimension mass_dimension(Dof dof) { return is_rotation(dof) ? dimension::rotary_mass : dimension::mass; }

} // namespace femoop
