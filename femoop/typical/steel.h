#pragma once

#include <string_view>

#include "femoop/model/property.h"
#include "femoop/model/quantity/units.h"

namespace femoop {

/// Structural steel as a new model gets it, its numbers in these units: nu 0.3, alpha 1.2e-5 1/K, density 7850 kg/m^3,
/// so that temperatures and self-weight can be added at once. \param E with its unit, such as "210 GPa"
Material steel(const Units& units, std::string_view E);

} // namespace femoop
