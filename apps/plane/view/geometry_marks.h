#pragma once

#include "apps/plane/view/plate_scene.h"

namespace plane {

/// Faces in the colours of their entries, with their names; holes bare, faces of no entry hatched.
void draw_regions(const PlateScene& scene);
/// Curves with their names, vertices, divisions as ticks; edges that dangle are dashed in the colour of a warning.
void draw_geometry(const PlateScene& scene);

/// What the cursor is over and what is selected, as broad marks below everything else.
void draw_highlights(const PlateScene& scene);

/// The look of a region: the same in the picture and in whatever lists them beside it.
ui::RoleStyle region_style(const ui::Theme& theme, femoop::plane::RegionId region);

} // namespace plane
