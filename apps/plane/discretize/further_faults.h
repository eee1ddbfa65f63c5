#pragma once

#include <vector>

#include "femoop/model/fault/fault.h"
#include "femoop/plane/model/plane_model.h"

namespace discretize {

/// What else is wrong with a drawn model that has errors already: its curves, regions, loads, divisions and checks are
/// looked at as if what has an error were right, stage by stage, as far as they do not depend on it. Where a curve is
/// wrong nobody knows the faces.
///
/// \param known  errors of `femoop::plane::check`; where a file has others, which leave gaps in the model, nothing is
///               found
std::vector<femoop::Fault> further_faults(femoop::plane::PlaneModel model, std::vector<femoop::Fault> known);

} // namespace discretize
