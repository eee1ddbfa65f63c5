#pragma once

#include "apps/drawing/geometry/projection.h"
#include "apps/drawing/geometry/structure_shape.h"
#include "apps/frame/session/session.h"
#include "ui/paint/painter.h"

#include <string>
#include <vector>

namespace frame {

/// Why the case that is shown has no results, as sentences. None where it has, and where the picture shows how its loads
/// move the structure.
std::vector<std::string> why_blank(const Session& session);

/// Likewise why a truss cannot be worked out where one is looked at.
std::vector<std::string> why_no_truss_shown(const Session& session);

/// Likewise why there is no funicular where one is looked at.
std::vector<std::string> why_no_funicular_shown(const Session& session);

/// Likewise why there is no virtual work where a displacement is looked at.
std::vector<std::string> why_no_work_shown(const Session& session);

/// Likewise why an envelope of trains that is looked at has no values.
std::vector<std::string> why_no_train_values(const Session& session);

/// Where a part of the structure stands and another can move: the members of that one, and why there are no results. It
/// takes the place of the motion while members are drawn, and moves nothing under the hand; the reason is written where
/// nothing is drawn.
void draw_loose_part(ui::Painter& painter, const Session& session, const DrawOptions& options,
                     const Projection& projection, const StructureShape& shape);

} // namespace frame
