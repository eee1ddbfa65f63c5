#pragma once

#include <optional>

#include "apps/frame/session/session.h"
#include "apps/frame/view/geometry/projection.h"
#include "apps/frame/view/geometry/structure_shape.h"
#include "ui/paint/geometry.h"

namespace frame {

/// What lies under the pointer: a node, or a cut through a member.
struct Pick {
    std::optional<femoop::NodeId> node;
    std::optional<Cut> cut;
};

/// The nearest node within `reach` logical pixels of the pointer, else the nearest member. Nodes come first because
/// members meet in them.
Pick pick(const StructureShape& shape, const Projection& projection, ui::Point pointer, double reach);

/// The cut moved to a place that is worth reading: within 5 logical pixels an end, the middle, a load's place or an
/// extreme of M; else to a round length, so that a value is read at 2.4 m and not at 2.39906 m.
Cut snapped(const Session& session, const StructureShape& shape, const Cut& cut, double pixels_per_length);

/// The place on the sheet of a cut.
ui::Point place_on_sheet(const StructureShape& shape, const Projection& projection, const Cut& cut);

} // namespace frame
