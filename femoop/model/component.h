#pragma once

#include "femoop/model/dof.h"
#include "femoop/model/quantity/quantity.h"

namespace femoop {

/// One component of a load, a settlement or a mass, named by its degree of freedom: for a load Dof::uy is fy or qy.
struct Component {
    Dof dof = Dof::ux;
    Quantity value;

    friend bool operator==(const Component&, const Component&) = default;
};

} // namespace femoop
