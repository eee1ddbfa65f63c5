#pragma once

#include "apps/euler/view/look.h"
#include "apps/euler/view/shapes/shapes.h"
#include "ui/canvas/orbit_camera.h"

#include <optional>
#include <span>

namespace euler {

/// The same topology drawn in the plane, as Schlegel drew polyhedra: one face of every shell is taken for the outside
/// and fills a disc around the others, which lie within it; none crosses another. Positions count for nothing.
///
/// A part that hangs on the rest by a ring alone is drawn inside the ring's face. Of a shell with handles no such
/// drawing exists: a sentence says so.
///
/// `outside` is the face to be taken for its shell; else the one with the most half-edges. The camera looks from above;
/// only how it pans and zooms counts.
Shapes planar_shapes(std::span<const Subject> subjects, const ui::OrbitCamera& camera, const Look& look,
                     std::optional<Part> outside = std::nullopt);

/// The camera that shows the whole drawing.
ui::OrbitCamera fitted_planar(std::span<const Subject> subjects, ui::Size sheet,
                              std::optional<Part> outside = std::nullopt);

} // namespace euler
