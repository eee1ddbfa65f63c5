#pragma once

#include "apps/cross/view/scene.h"

namespace cross {

/// The structure with its loads, and the calculation sheet with its cells to fill on the structure's own sketch.
/// Nothing else of the structure is shown until the sheet is right: then its moments are.
/// \pre the scene has a paper
Drawn draw_exercise(ui::Painter& painter, const Scene& scene);

} // namespace cross
