#pragma once

#include <vector>

#include "femoop/discretisation/discretisation.h"
#include "femoop/model/component.h"

namespace femoop::influence {

/// A load along global axes fx fy fz mx my mz, times a factor, as the components of a case's load; `unit_load` undoes it.
inline std::vector<Component> components_of(const NodeVector& load, double factor = 1.0)
{
    std::vector<Component> components;
    for (const Dof dof : all_dofs)
        if (load[index(dof)] != 0.0) components.push_back({.dof = dof, .value = factor * load[index(dof)]});
    return components;
}

inline bool is_couple(const NodeVector& load) { return load[0] == 0.0 && load[1] == 0.0 && load[2] == 0.0; }

} // namespace femoop::influence
