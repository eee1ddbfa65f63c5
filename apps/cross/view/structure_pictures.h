#pragma once

#include "apps/cross/view/panels.h"

namespace cross {

/// A frame as large as the marks of its loads and lengths leave room for, a beam at the height where they all have it.
LoadedView view_of_loads(const Panel& panel, const Scene& scene, const ui::Fonts& fonts);
/// The structure with the loads of its case. \returns what a hand can take hold of
drawing::Grips draw_loaded(ui::Painter& painter, const Panel& panel, const Scene& scene);

/// The deformed shape of the present state, a lock on each clamped joint with the moment that it holds.
void draw_deformed_state(ui::Painter& painter, const Panel& panel, const Scene& scene);

/// The moments of the present state on the tension side. Where a joint is not balanced they jump.
void draw_moment_state(ui::Painter& painter, const Panel& panel, const Scene& scene);

/// The shears of the present state and what the supports do.
void draw_shear_state(ui::Painter& painter, const Panel& panel, const Scene& scene);

} // namespace cross
