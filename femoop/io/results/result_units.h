#pragma once

#include <string>

#include "femoop/model/dof.h"
#include "femoop/model/quantity/units.h"
#include "femoop/result/components.h"

namespace femoop {

/// A unit of a table: printed = value * factor.
struct PrintedUnit {
    std::string name;
    double factor = 1.0;
};

/// The units that tables of results have, quantity by quantity.
struct ResultUnits {
    PrintedUnit length;       ///< of places
    PrintedUnit displacement; ///< of nodes and along members
    PrintedUnit rotation;
    PrintedUnit force, moment;
    PrintedUnit stress; ///< of plates

    const PrintedUnit& of_displacement(Dof dof) const { return is_rotation(dof) ? rotation : displacement; }
    const PrintedUnit& of_force(Dof dof) const { return is_rotation(dof) ? moment : force; }
    const PrintedUnit& of(MemberComponent component) const
    {
        if (is_displacement(component)) return displacement;
        return is_moment(component) ? moment : force;
    }
};

/// The base units of a file and what follows from them; rotations in rad.
ResultUnits result_units(const Units& units);

} // namespace femoop
