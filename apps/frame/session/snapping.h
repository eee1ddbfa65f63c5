#pragma once

#include "apps/drawing/geometry/structure_shape.h"
#include "apps/drawing/pick.h"
#include "apps/frame/document/drawing_names.h"
#include "apps/frame/session/session.h"

namespace frame {

/// The cut moved to a place that is worth reading: within 5 logical pixels an end, the middle, a load's place or an
/// extreme of M; else to a round length, so that a value is read at 2.4 m and not at 2.39906 m.
Cut snapped(const Session& session, const StructureShape& shape, const Cut& cut, double pixels_per_length);

} // namespace frame
