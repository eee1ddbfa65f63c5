#pragma once

#include "apps/euler/view/look.h"
#include "apps/euler/view/shapes/shapes.h"
#include "apps/euler/view/solid/placed_solid.h"
#include "ui/canvas/orbit_camera.h"

#include <span>

namespace euler {

/// Solids in space.
///
/// Faces are painted from back to front (solid/paint_order.h). A half-edge stands a few pixels inside its face, in the
/// face's plane; where the face has no area, or runs along the line of sight, it stands beside its edge on the sheet.
/// An edge or a vertex is hidden if some piece covers its middle; where there are more than `most_compared` pieces, if
/// all its faces are seen from inside. Half-edges shorter than an arrow's head on the sheet are left out.
Shapes solid_shapes(std::span<const Subject> subjects, const ui::OrbitCamera& camera, const Look& look);

/// The camera that shows everything, from where the given one stands. One point alone, and no solid, are shown too.
ui::OrbitCamera fitted(ui::OrbitCamera camera, std::span<const Subject> subjects, const Look& look, ui::Size sheet);

/// What stands where of solids that were put into their places before.
Shapes shapes_of(const PlacedSolids& solids, const ViewTransform& transform, const Look& look);

} // namespace euler
