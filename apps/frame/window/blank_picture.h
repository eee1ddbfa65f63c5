#pragma once

#include "apps/frame/session/session.h"
#include "ui/paint/painter.h"

namespace frame {

/// At the foot of the picture: why the case that is shown has no results. Nothing where it has, and where the picture
/// shows how its loads move the structure.
void draw_why_blank(ui::Painter& painter, const Session& session, const DrawOptions& options);

} // namespace frame
