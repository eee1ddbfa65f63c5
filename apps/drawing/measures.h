#pragma once

#include "femoop/model/dof.h"
#include "ui/text/display_units.h"

namespace drawing {

/// What something along or about a degree of freedom is measured in.
struct Measures {
    ui::Measure along, about;
    constexpr ui::Measure of(femoop::Dof dof) const { return femoop::is_rotation(dof) ? about : along; }
};
inline constexpr Measures force_measures{ui::Measure::Force, ui::Measure::Moment};
inline constexpr Measures line_load_measures{ui::Measure::ForcePerLength, ui::Measure::MomentPerLength};
inline constexpr Measures displacement_measures{ui::Measure::Displacement, ui::Measure::Rotation};
inline constexpr Measures spring_measures{ui::Measure::ForcePerLength, ui::Measure::MomentPerAngle};

} // namespace drawing
