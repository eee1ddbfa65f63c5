#pragma once

#include "femoop/plane/model/plane_model.h"

namespace femoop::plane {

/// The same model with each run of a curve as a curve of its own, the first one under the old name: as a file has them.
/// Fields that are given along the curve become those of its parts, checks of a curve those of its first run.
PlaneModel with_runs_as_curves(const PlaneModel& model);

} // namespace femoop::plane
