#pragma once

#include "femoop/model/dof.h"
#include "femoop/model/expected.h"

namespace femoop {

/// How large the numbers of a case are, those that cancel included (what heat would do to members that cannot give
/// way, and to free ones), and what the structure's size makes of one kind out of the other. A number far below is
/// nothing but rounding.
struct Magnitudes {
    double force = 0.0;
    double moment = 0.0;
    double displacement = 0.0;
    double rotation = 0.0;

    double displacement_of(Dof dof) const { return is_rotation(dof) ? rotation : displacement; }
    double force_of(Dof dof) const { return is_rotation(dof) ? moment : force; }
    double of(MemberComponent component) const;
};

/// The value, or 0 where it is nothing but round-off beside numbers of this size.
double without_rounding(double value, double magnitude);

} // namespace femoop
