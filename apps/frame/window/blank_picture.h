#pragma once

#include "apps/drawing/geometry/projection.h"
#include "apps/drawing/geometry/structure_shape.h"
#include "apps/frame/session/session.h"
#include "ui/paint/painter.h"

namespace frame {

/// At the foot of the picture: why the case that is shown has no results. Nothing where it has, and where the picture
/// shows how its loads move the structure.
void draw_why_blank(ui::Painter& painter, const Session& session, const DrawOptions& options);

/// Where a part of the structure stands and another can move: the members of that one, and why there are no results. It
/// takes the place of the motion while members are drawn, and moves nothing under the hand.
void draw_loose_part(ui::Painter& painter, const Session& session, const DrawOptions& options,
                     const Projection& projection, const StructureShape& shape);

} // namespace frame
